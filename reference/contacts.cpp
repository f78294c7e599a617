#include "reference/contacts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/error.hpp"
#include "cases/hand/hand_model.hpp"

namespace handhold::reference {

using Eigen::Vector3d;

Contacts::Contacts(const Scene& scene, double accuracy)
    : scene_(scene),
      body_(scene.bodies.front()),
      element_{scene.contact.stiffness, scene.contact.damping, body_.friction,
               std::max(10 * touch_depth, 100 * accuracy)},
      layout_(make_layout(scene)),
      surface_(body_.field),
      seed_distance_(scene.patch.contact_offset),
      // Beyond the band distances are clamped: a patch is dropped there at the latest.
      drop_distance_(std::min(2 * seed_distance_, 0.99 * surface_.band())),
      motion_(layout_.pads.size()),
      memory_(layout_.id.size()),
      near_(layout_.pads.size()) {
  if (seed_distance_ > 0.9 * surface_.band())
    throw InputError(
        fmt::format("contact_offset={} m: must be at most 0.9 of the voxel band, {} m (voxelize with a wider band)",
                    seed_distance_, surface_.band()));
}

std::string Contacts::describe(int slot) const {
  const SampleId& id = layout_.id[std::size_t(slot)];
  return fmt::format("hand {} {} sample {}", int(id.hand), phalanx_name(id.phalanx), int(id.sample));
}

bool Contacts::present_after(int hand, double t) const {
  const std::vector<Interval>& presence = scene_.hands[std::size_t(hand)].motion->presence();
  return std::any_of(presence.begin(), presence.end(), [&](const Interval& i) { return i.begin <= t && t < i.end; });
}

const Contacts::PhalanxMotion& Contacts::motion_of(std::size_t pad, double t) {
  PhalanxMotion& m = motion_[pad];
  if (m.t == t) return m;
  const Pad& p = layout_.pads[pad];
  const HandMotion& hand = *scene_.hands[std::size_t(p.hand)].motion;
  m = {t, hand.pose(p.phalanx, t), hand.twist(p.phalanx, t)};
  return m;
}

const AnchorSurface& Contacts::surface_at(std::size_t slot, const Vector3d& anchor, bool with_curvature) {
  SurfaceMemory& m = memory_[slot];
  if (!with_curvature && m.anchor == anchor) return m.surface;  // stick: the anchor has not moved by a bit
  const SurfaceSample s = with_curvature ? surface_.evaluate(anchor) : surface_.gradient(anchor);
  const double slope = s.gradient.norm();
  m.anchor = anchor;
  m.surface = {s.value / slope, s.gradient / slope, s.hessian / slope};
  return m.surface;
}

Sample Contacts::place(std::size_t slot, double t, const BodyMotion& body, const Vector3d& p_P) {
  const PhalanxMotion& phalanx = motion_of(std::size_t(layout_.pad_of[slot]), t);
  Sample s;
  const Vector3d arm = phalanx.X_WP.R * p_P;
  s.p_W = phalanx.X_WP.p + arm;
  s.v_W = phalanx.V_WP.v + phalanx.V_WP.w.cross(arm);
  const Vector3d offset = s.p_W - body.p_WO;
  s.p_O = body.R_WO.transpose() * offset;
  s.v_O = body.R_WO.transpose() * (s.v_W - body.v_WO - body.w_WO.cross(offset));
  return s;
}

/// Apart: how deep p is; with damping it must be pushing too: k d + c d' > 0 at the surface point below p.
double Contacts::touch_witness(const BodyMotion& body, const Sample& s) const {
  const double depth = -surface_.value(s.p_O);
  if (element_.damping == 0 || depth <= touch_depth) return depth - touch_depth;
  const Foot foot = surface_.foot(s.p_O);
  const Vector3d r = s.p_O - foot.p_O;
  const Vector3d v_C = s.v_O + (body.R_WO.transpose() * body.w_WO).cross(r);
  const double pressed = foot.depth - element_.damping / element_.stiffness * v_C.dot(foot.n_O);
  return std::min(depth - touch_depth, pressed);
}

void Contacts::evaluate_sample(std::size_t slot, const BodyMotion& body, Mode mode, const Vector3d& anchor, Sample& s) {
  if (mode == Mode::apart) {
    s.gap = touch_witness(body, s);
    return;
  }
  const bool with_curvature = mode == Mode::slip && element_.damping == 0;
  const AnchorSurface& surface = surface_at(slot, anchor, with_curvature);
  s.n_O = surface.n;
  const Vector3d r = s.p_O - anchor;
  const Vector3d w_O = body.R_WO.transpose() * body.w_WO;
  s.response = respond(element_, mode, {r, s.v_O + w_O.cross(r), s.v_O}, surface);
  s.gap = s.response.release;
  s.friction = s.response.friction;
}

Pose Contacts::pose_in_body(std::size_t pad, double t, const BodyMotion& body) {
  const Pose X_WO{Eigen::Quaterniond(body.R_WO), body.p_WO};
  return X_WO.inverse() * motion_of(pad, t).X_WP;
}

/// Distance to seeding (no patch) or dropping (patch, all samples apart); only its sign and zero must be right.
///
/// No skin point moved farther than `moved` since the distance was last computed, so often that answers; the search for
/// the nearest point costs more than all the rest.
double Contacts::nearness(std::size_t pad, double t, const BodyMotion& body, const Modes& modes) {
  const Pad& p = layout_.pads[pad];
  if (p.given || !modes.present[std::size_t(p.hand)]) return -1;
  const auto first = modes.mode.begin() + p.first;
  const bool exists = modes.exists[std::size_t(p.first)];
  if (exists && std::any_of(first, first + p.count, [](Mode m) { return m != Mode::apart; })) return -1;
  const Pose X_OP = pose_in_body(pad, t, body);
  NearMemory& near = near_[pad];
  if (near.known) {
    const double angle_half_sine = (near.X_OP.R.conjugate() * X_OP.R).vec().norm();
    const double moved = (X_OP.p - near.X_OP.p).norm() + 2 * angle_half_sine * p.reach;
    const double bound = exists ? near.distance + moved - drop_distance_ : seed_distance_ - (near.distance - moved);
    if (bound < 0) return bound;
  }
  const double outside = body_.field->bounds().exteriorDistance(X_OP.p) - p.reach;
  if (!exists && outside > seed_distance_) return seed_distance_ - outside;
  const HandMotion& hand = *scene_.hands[std::size_t(p.hand)].motion;
  near = {true, X_OP, nearest(hand.model().shape(p.phalanx), X_OP, *body_.field).distance};
  return exists ? near.distance - drop_distance_ : seed_distance_ - near.distance;
}

void Contacts::evaluate(double t, const BodyMotion& body, const Modes& modes, const Anchors& anchors, Evaluation& out) {
  out.samples.resize(layout_.id.size());
  out.nearness.resize(layout_.pads.size());
  out.force_W = out.torque_W = Vector3d::Zero();
  out.hand_power = out.dissipation = 0;
  out.singular_slot = -1;
  Vector3d force_O = Vector3d::Zero(), torque_O = Vector3d::Zero();
  for (std::size_t pad = 0; pad < layout_.pads.size(); ++pad) {
    const Pad& p = layout_.pads[pad];
    out.nearness[pad] = nearness(pad, t, body, modes);
    const bool live = modes.present[std::size_t(p.hand)];
    for (std::size_t slot = std::size_t(p.first); slot < std::size_t(p.first + p.count); ++slot) {
      Sample& s = out.samples[slot];
      if (!live || !modes.exists[slot]) {
        s = Sample();
        continue;
      }
      s = place(slot, t, body, modes.p_P[slot]);
      const Vector3d anchor = anchors.col(Eigen::Index(slot));
      evaluate_sample(slot, body, modes.mode[slot], anchor, s);
      if (modes.mode[slot] == Mode::apart) continue;
      if (s.response.singular) out.singular_slot = int(slot);
      force_O += s.response.force;
      torque_O += anchor.cross(s.response.force);
      out.hand_power += (body.R_WO * s.response.force).dot(s.v_W);
      out.dissipation += s.response.dissipation;
    }
  }
  out.force_W = body.R_WO * force_O;
  out.torque_W = body.R_WO * torque_O;
}

double Contacts::elastic_energy(const Modes& modes, const Evaluation& evaluation) const {
  double energy = 0;
  for (std::size_t slot = 0; slot < modes.mode.size(); ++slot) {
    const Response& r = evaluation.samples[slot].response;
    if (modes.mode[slot] != Mode::apart) energy += 0.5 * element_.stiffness * (r.depth * r.depth + r.lag.squaredNorm());
  }
  return energy;
}

}  // namespace handhold::reference
