// SPDX-License-Identifier: GPL-3.0-or-later
// What is not in contact, but may come to be: the witnesses of apart samples and of patches.

#include <algorithm>

#include "reference/contacts.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

constexpr double none = -1e6;  // of a witness: nothing is near

}  // namespace

/// N / k, were the sample to touch at `foot` [m].
double Contacts::pressing(std::size_t slot, const Sample& s, const Foot& foot) const {
  const Element& element = elements_[std::size_t(layout_.pad_of[slot])];
  const double ratio = element.damping / element.stiffness;  // [s]
  if (!foot.hold.caught()) return foot.depth - ratio * s.v_O.dot(foot.n_O);
  return surfaces_[layout_.id[slot].body]->way(s.p_O - foot.p_O + ratio * s.v_O, foot.hold).N;
}

/// Of a sample that keeps its sheet: it touches that again when it presses, and forgets it when it is out.
double Contacts::kept_witness(std::size_t slot, const Sample& s, const Place& anchor) const {
  const Surface& surface = *surfaces_[layout_.id[slot].body];
  const double outside = surface.value(s.p_O);
  // Deeper by touch_depth than where it was released, so that round-off cannot toggle it.
  return outside > 0 ? outside : pressing(slot, s, surface.foot_on_sheet(s.p_O, anchor)) - touch_depth;
}

/// How deep p is; with damping it must be pushing too: k d + c d' > 0 at the surface point below p.
double Contacts::touch_witness(std::size_t slot, const Sample& s) const {
  const Surface& surface = *surfaces_[layout_.id[slot].body];
  const Element& element = elements_[std::size_t(layout_.pad_of[slot])];
  const double depth = -surface.value(s.p_O);
  if (element.damping == 0 || depth <= touch_depth) return depth - touch_depth;
  return std::min(depth - touch_depth, pressing(slot, s, surface.foot(s.p_O)));
}

/// The samples of a given pad are at least this far from the body [m]; 0: they may touch.
double Contacts::far(const Pad& pad, double t, const Motions& motions) {
  const Motion& from = carrier(pad, t, motions);
  const Motion& body = motions[std::size_t(pad.body)];
  const Vector3d middle_O = body.R.transpose() * (from.p + from.R * pad.middle - body.p);
  const Eigen::AlignedBox3d bounds = scene_.bodies[std::size_t(pad.body)].field->bounds();
  const double margin = scene_.bodies[std::size_t(pad.body)].field->grid().spacing;  // the spline's rounding
  return std::max(0.0, bounds.exteriorDistance(middle_O) - pad.reach - margin);
}

Pose Contacts::pose_in_body(const Pad& pad, double t, const Motions& motions) {
  const Motion& body = motions[std::size_t(pad.body)];
  const Pose X_WO{Eigen::Quaterniond(body.R), body.p};
  return X_WO.inverse() * phalanx(pad, t).X_WP;
}

/// Distance to seeding (no patch) or dropping (patch, all samples apart); only its sign and zero must be right.
///
/// No skin point moved farther than `moved` since the distance was last computed, so often that answers; the search for
/// the nearest point costs more than all the rest.
double Contacts::nearness(std::size_t index, double t, const Motions& motions, const Modes& modes) {
  const Pad& pad = layout_.pads[index];
  if (pad.given || !live(pad, modes) || modes.touching[index] > 0) return none;
  const bool exists = modes.exists[std::size_t(pad.first)];
  const double drop = drop_distance_[std::size_t(pad.body)];
  const Pose X_OP = pose_in_body(pad, t, motions);
  NearMemory& near = near_[index];
  if (near.known) {
    const double angle_half_sine = (near.X_OP.R.conjugate() * X_OP.R).vec().norm();
    const double moved = (X_OP.p - near.X_OP.p).norm() + 2 * angle_half_sine * pad.reach;
    const double bound = exists ? near.distance + moved - drop : seed_distance_ - (near.distance - moved);
    if (bound < 0) return bound;
  }
  const VoxelField& field = *scene_.bodies[std::size_t(pad.body)].field;
  const double outside = field.bounds().exteriorDistance(X_OP.p) - pad.reach;
  if (!exists && outside > seed_distance_) return seed_distance_ - outside;
  const HandMotion& hand = *scene_.hands[std::size_t(pad.hand)].motion;
  near = {true, X_OP, nearest(hand.model().shape(pad.carrier), X_OP, field).distance};
  return exists ? near.distance - drop : seed_distance_ - near.distance;
}

void Contacts::watch(double t, const Motions& motions, const Modes& modes, const AnchorsView& anchors,
                     Evaluation& out) {
  out.touch = out.nearness = none;
  out.touch_slot = -1;
  for (std::size_t i = 0; i < layout_.pads.size(); ++i) {
    const Pad& pad = layout_.pads[i];
    if (!live(pad, modes)) continue;
    out.nearness = std::max(out.nearness, nearness(i, t, motions, modes));
    if (!modes.exists[std::size_t(pad.first)]) continue;
    const double distance = pad.given && modes.touching[i] == 0 ? far(pad, t, motions) : 0;
    if (distance > 0) {
      out.touch = std::max(out.touch, -distance);
      continue;
    }
    for (std::size_t slot = std::size_t(pad.first); slot < std::size_t(pad.first + pad.count); ++slot) {
      if (modes.mode[slot] != Mode::apart || !modes.exists[slot]) continue;
      const Sample s = place(slot, t, motions, modes.p_P[slot]);
      const double depth = modes.kept[slot] ? kept_witness(slot, s, {anchors.col(Eigen::Index(slot)), modes.hold[slot]})
                                            : touch_witness(slot, s);
      if (depth > out.touch) out.touch = depth, out.touch_slot = int(slot);
    }
  }
  out.watched = true;
}

}  // namespace handhold::reference
