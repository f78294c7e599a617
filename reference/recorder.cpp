// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/recorder.hpp"

#include <cmath>

#include <fmt/format.h>

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

BodyState body_state(const Motion& body) {
  return {{Eigen::Quaterniond(body.R).normalized(), body.p}, {body.w, body.v}};
}

/// Of a sample that is apart: its distance and, within the band, the surface point below it.
void describe_apart(const Surface& surface, const Motion& body, const Sample& s, ContactState& c) {
  const double distance = surface.value(s.p_O);
  c.depth = -distance;
  c.C_W = c.p_W;
  if (!(std::abs(distance) < 0.9 * surface.band())) return;
  const Foot foot = surface.foot(s.p_O);
  c.depth = foot.depth;
  c.C_W = body.p + body.R * foot.p_O;
  c.n_W = body.R * foot.n_O;
}

ContactState contact_state(const SampleId& id, Mode mode, const Vector3d& anchor, const Sample& s, const Motion& body,
                           const Surface& surface) {
  ContactState c;
  c.id = id;
  c.mode = mode;
  c.p_W = s.p_W;
  if (mode == Mode::apart) {
    describe_apart(surface, body, s, c);
    return c;
  }
  c.depth = s.response.depth;
  c.C_W = body.p + body.R * anchor;
  c.n_W = body.R * s.n_O;
  c.f_W = body.R * s.response.force;
  return c;
}

double kinetic(const Body& body, const Motion& m) {
  const Vector3d v = m.v + m.w.cross(m.R * body.inertia.center);
  const Vector3d w_O = m.R.transpose() * m.w;
  const double turning = body.mobility == Mobility::free ? 0.5 * w_O.dot(body.inertia.about_center * w_O) : 0.0;
  return 0.5 * body.inertia.mass * v.squaredNorm() + turning;
}

double potential(const Body& body, const Motion& m, const Vector3d& gravity) {
  const Vector3d start = body.X_WO.p + body.X_WO.R.normalized() * body.inertia.center;
  return -body.inertia.mass * gravity.dot(m.p + m.R * body.inertia.center - start);
}

/// Of every body: "cube: triangles, for ...".
std::string surfaces(const Scene& scene, SurfaceModel model) {
  std::string text;
  for (const Body& body : scene.bodies)
    text += (text.empty() ? "" : "; ") + body.name + ": " + choose_surface(*body.field, model).why;
  return text;
}

}  // namespace

Recorder::Recorder(const Scene& scene, const Options& options) : scene_(scene) {
  recording_.engine = "reference";
  recording_.scene = scene.name;
  for (const Body& body : scene.bodies) recording_.body_names.push_back(body.name);
  provenance("accuracy", fmt::format("{:g}", options.accuracy));
  provenance("max_step", fmt::format("{:g} s", options.max_step));
  provenance("frame_rate", options.frame_times.empty() ? fmt::format("{:g} Hz", options.frame_rate) : "at given times");
  provenance("surface", surfaces(scene, options.surface));
  provenance("compiler", "g++ " __VERSION__);
}

Energy Recorder::energy(const Motions& motions, const Modes& modes, const Evaluation& evaluation,
                        const Contacts& contacts, const Work& work) const {
  Energy energy;
  energy.elastic = contacts.elastic_energy(modes, evaluation);
  energy.dissipated = work.dissipated;
  energy.hand_work = work.hand;
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
    if (scene_.bodies[i].mobility == Mobility::fixed) continue;
    energy.kinetic += kinetic(scene_.bodies[i], motions[i]);
    energy.potential += potential(scene_.bodies[i], motions[i], scene_.gravity);
  }
  return energy;
}

void Recorder::frame(double t, const Motions& motions, const Modes& modes, const AnchorsView& anchors,
                     const Evaluation& evaluation, Contacts& contacts, const Work& work) {
  Frame frame;
  frame.t = t;
  for (const Motion& motion : motions) frame.bodies.push_back(body_state(motion));
  const Layout& layout = contacts.layout();
  for (std::size_t slot = 0; slot < layout.id.size(); ++slot) {
    const SampleId& id = layout.id[slot];
    if (!modes.exists[slot] || !(id.belongs_to_body() || modes.present[id.hand])) continue;
    const bool apart = modes.mode[slot] == Mode::apart;
    const Sample s = apart ? contacts.place(slot, t, motions, modes.p_P[slot]) : evaluation.samples[slot];
    const Surface& surface = contacts.surface(id.body);
    if (apart && id.belongs_to_body() && surface.value(s.p_O) > scene_.patch.contact_offset) continue;
    frame.contacts.push_back(
        contact_state(id, modes.mode[slot], anchors.col(Eigen::Index(slot)), s, motions[id.body], surface));
  }
  frame.contacts.shrink_to_fit();  // a long trace has many frames
  frame.energy = energy(motions, modes, evaluation, contacts, work);
  recording_.frames.push_back(std::move(frame));
}

void Recorder::events(double t, double window, const std::vector<Transition>& transitions, const Motions& motions,
                      const Layout& layout) {
  for (const Transition& x : transitions) {
    const SampleId& id = layout.id[std::size_t(x.slot)];
    recording_.events.push_back({t, window, x.kind, id, body_state(motions[id.body])});
  }
}

void Recorder::undecided(double t, const std::vector<Undecided>& found, const Layout& layout) {
  for (const Undecided& x : found) recording_.ambiguities.push_back({t, layout.id[std::size_t(x.slot)], x.what});
}

void Recorder::end(Outcome outcome, const std::string& note) {
  recording_.outcome = outcome;
  recording_.note = note;
}

}  // namespace handhold::reference
