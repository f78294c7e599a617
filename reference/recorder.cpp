#include "reference/recorder.hpp"

#include <cmath>

#include <fmt/format.h>

namespace handhold::reference {
namespace {

BodyState body_state(const BodyMotion& body) {
  return {{Eigen::Quaterniond(body.R_WO).normalized(), body.p_WO}, {body.w_WO, body.v_WO}};
}

using Eigen::Vector3d;

/// Of a sample that is apart: its distance and, within the band, the surface point below it.
void describe_apart(const SplineSurface& surface, const BodyMotion& body, const Sample& s, ContactState& c) {
  const double distance = surface.value(s.p_O);
  c.depth = -distance;
  c.C_W = c.p_W;
  if (!(std::abs(distance) < 0.9 * surface.band())) return;
  const Foot foot = surface.foot(s.p_O);
  c.depth = foot.depth;
  c.C_W = body.p_WO + body.R_WO * foot.p_O;
  c.n_W = body.R_WO * foot.n_O;
}

ContactState contact_state(const SampleId& id, Mode mode, const Vector3d& anchor, const Sample& s,
                           const BodyMotion& body, const SplineSurface& surface) {
  ContactState c;
  c.id = id;
  c.mode = mode;
  c.p_W = s.p_W;
  if (mode == Mode::apart) {
    describe_apart(surface, body, s, c);
    return c;
  }
  c.depth = s.response.depth;
  c.C_W = body.p_WO + body.R_WO * anchor;
  c.n_W = body.R_WO * s.n_O;
  c.f_W = body.R_WO * s.response.force;
  return c;
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Options& options) : scene_(scene) {
  recording_.engine = "reference";
  recording_.scene = scene.name;
  for (const Body& body : scene.bodies) recording_.body_names.push_back(body.name);
  provenance("accuracy", fmt::format("{:g}", options.accuracy));
  provenance("max_step", fmt::format("{:g} s", options.max_step));
  provenance("frame_rate", fmt::format("{:g} Hz", options.frame_rate));
  provenance("compiler", "g++ " __VERSION__);
}

Energy Recorder::energy(const BodyMotion& body, const Modes& modes, const Evaluation& evaluation,
                        const Contacts& contacts, const Work& work) const {
  Energy energy;
  energy.elastic = contacts.elastic_energy(modes, evaluation);
  energy.dissipated = work.dissipated;
  energy.hand_work = work.hand;
  const Body& solid = scene_.bodies.front();
  if (solid.mobility == Mobility::fixed) return energy;
  const Vector3d arm = body.R_WO * solid.inertia.center;
  const Vector3d v = body.v_WO + body.w_WO.cross(arm);
  const Vector3d w_O = body.R_WO.transpose() * body.w_WO;
  energy.kinetic = 0.5 * solid.inertia.mass * v.squaredNorm();
  if (solid.mobility == Mobility::free) energy.kinetic += 0.5 * w_O.dot(solid.inertia.about_center * w_O);
  const Vector3d start = solid.X_WO.p + solid.X_WO.R.normalized() * solid.inertia.center;
  energy.potential = -solid.inertia.mass * scene_.gravity.dot(body.p_WO + arm - start);
  return energy;
}

void Recorder::frame(double t, const BodyMotion& body, const Modes& modes, const Anchors& anchors,
                     const Evaluation& evaluation, const Contacts& contacts, const Work& work) {
  Frame frame;
  frame.t = t;
  frame.bodies.push_back(body_state(body));
  const Layout& layout = contacts.layout();
  for (std::size_t slot = 0; slot < layout.id.size(); ++slot) {
    const bool live = modes.present[layout.id[slot].hand];
    if (!modes.exists[slot] || !live) continue;
    frame.contacts.push_back(contact_state(layout.id[slot], modes.mode[slot], anchors.col(Eigen::Index(slot)),
                                           evaluation.samples[slot], body, contacts.surface()));
  }
  frame.energy = energy(body, modes, evaluation, contacts, work);
  recording_.frames.push_back(std::move(frame));
}

void Recorder::events(double t, double window, const std::vector<Transition>& transitions, const BodyMotion& body,
                      const Layout& layout) {
  for (const Transition& x : transitions)
    recording_.events.push_back({t, window, x.kind, layout.id[std::size_t(x.slot)], body_state(body)});
}

void Recorder::end(Outcome outcome, const std::string& note) {
  recording_.outcome = outcome;
  recording_.note = note;
}

}  // namespace handhold::reference
