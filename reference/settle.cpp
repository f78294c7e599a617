// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to contacts at events: the discrete half of Contacts.

#include <algorithm>
#include <cmath>

#include "cases/model/defect.hpp"
#include "reference/contacts.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

/// Of one sample at one instant: touch, break away and stick again are three; the rest is for faces smaller than a lag.
constexpr int most_changes = 100;

/// A sample that sticks again keeps this far inside its cone, relatively and [m]: on the cone itself, where mu_s = mu_d
/// puts it, its witness would start at zero and the next breakaway would be missed. Far below every tolerance, far
/// above round-off.
constexpr double cone_margin = 1e-12;
constexpr double cone_margin_length = 1e-16;

constexpr double most_off_cone = 1e-10;  // of an undamped lag [m]

Vector3d tangential(const Vector3d& v, const Vector3d& n) { return v - v.dot(n) * n; }

}  // namespace

struct Contacts::Slot {
  std::size_t index;
  const Pad& pad;
  const Element& element;
  const Surface& surface;
  Mode mode;
  Foothold hold;
  Vector3d anchor;
  Sample s;
  std::vector<EventKind> news{};

  void enter(Mode next, EventKind kind) {
    mode = next;
    news.push_back(kind);
  }
  [[nodiscard]] bool undamped() const { return element.damping == 0; }
  [[nodiscard]] double stored() const {
    const Response& r = s.response;
    return mode == Mode::apart ? 0 : 0.5 * element.stiffness * (r.depth * r.depth + r.lag.squaredNorm());
  }
};

/// The anchor for which the lag is (ratio d − margin) along `direction` (made tangential): fixed point, contracts by κ
/// d.
Vector3d Contacts::with_lag(std::size_t slot, const Vector3d& p_O, const Vector3d& anchor, const Foothold& hold,
                            const Vector3d& direction, double ratio, double margin) const {
  const Surface& surface = *surfaces_[layout_.id[slot].body];
  Vector3d a = surface.project(anchor, hold);
  double off = 0;
  for (int i = 0; i < 60; ++i) {
    const Vector3d n = surface.at(a, hold, false).n;
    const Vector3d r = p_O - a;
    const double depth = -r.dot(n);
    const Vector3d wanted = std::max(0.0, ratio * depth - margin) * tangential(direction, n).normalized();
    const Vector3d error = r + depth * n - wanted;
    off = error.norm();
    if (off < 2e-17) break;  // round-off
    a = surface.project(a + error, hold);
  }
  if (!(off < most_off_cone))
    throw CannotAdvance(describe(int(slot)) +
                        ": no anchor on an edge sharper than the depth has this lag (give the "
                        "contact damping)");
  return a;
}

/// Response and witnesses in the mode it has now.
void Contacts::look(Slot& x) {
  x.s.response = Response();
  x.s.n_O.setZero();
  x.s.friction = x.s.edge = -1;
  if (x.mode == Mode::apart)
    x.s.gap = touch_witness(x.index, x.s);
  else
    respond_at(x.index, x.mode, x.anchor, x.hold, x.s);
}

/// Anchor below p, so that the lag is zero; slips at once if it moves sideways faster than the cone opens.
void Contacts::touch(Slot& x) {
  const Foot foot = x.surface.foot(x.s.p_O);
  x.anchor = foot.p_O;
  x.hold = foot.hold;
  x.enter(Mode::stick, EventKind::touch);
  if (x.hold.caught()) return;
  look(x);
  const Friction& mu = x.element.friction;
  if (!x.undamped()) {
    if (x.s.friction > 0 || mu.mu_static == 0) x.mode = Mode::slip;
    return;
  }
  // Undamped, at depth 0, the cone has no width: compare rates, d|e|/dt with mu_s dd/dt. Deep, e = 0 is well inside it.
  const Vector3d v_t = tangential(x.s.v_O, foot.n_O);
  const double speed = -x.s.v_O.dot(foot.n_O);
  const bool shallow = foot.depth < 10 * touch_depth + 2 * event_window_ * speed;  // it has only just come in
  const bool slips =
      mu.mu_static == 0 ||
      (shallow && v_t.norm() > DEFECT(reference_first_touch_at_mu_d, mu.mu_static, mu.mu_dynamic) * speed);
  if (!slips) return;
  x.mode = Mode::slip;
  x.anchor = with_lag(x.index, x.s.p_O, x.anchor, x.hold, v_t, mu.mu_dynamic, 0);
}

void Contacts::break_away(Slot& x) {
  Vector3d direction = x.s.response.lag;
  if (x.hold.caught()) {
    const Approach approach{x.s.p_O - x.anchor, x.s.v_O};
    if (way_out(x.element, approach, x.surface.wedge(x.hold)) == 1) x.hold.face = x.hold.wall;
    x.hold.wall = -1;
    direction = approach.r;  // with_lag makes it tangential to the face
  }
  if (x.undamped())
    x.anchor = with_lag(x.index, x.s.p_O, x.anchor, x.hold, direction, x.element.friction.mu_dynamic, 0);
  x.enter(Mode::slip, EventKind::breakaway);
}

void Contacts::stick_again(Slot& x) {
  if (x.undamped())
    x.anchor = with_lag(x.index, x.s.p_O, x.anchor, x.hold, x.s.response.lag,
                        x.element.friction.mu_dynamic * (1 - cone_margin), cone_margin_length);
  x.enter(Mode::stick, EventKind::restick);
}

/// The anchor has left its face.
bool Contacts::go_over(Slot& x) {
  const Foothold next = x.surface.beyond(x.anchor, x.hold);
  if (next == x.hold) return false;
  x.hold = next;
  x.anchor = x.surface.project(x.anchor, x.hold);
  if (x.hold.caught()) {
    x.enter(Mode::stick, EventKind::restick);
  } else if (x.undamped()) {
    x.anchor = with_lag(x.index, x.s.p_O, x.anchor, x.hold, x.s.p_O - x.anchor, x.element.friction.mu_dynamic, 0);
  }
  return true;
}

/// Carries out one change that is due; false if there is none.
bool Contacts::change(Slot& x, Settling& now) {
  if (!live(x.pad, now.modes)) {
    if (x.mode != Mode::apart) x.enter(Mode::apart, EventKind::release);
    return false;
  }
  const bool slipping = x.mode == Mode::slip;
  if (x.mode == Mode::apart) {
    if (!(x.s.gap > 0)) return false;
    touch(x);
  } else if (x.s.gap > 0) {
    x.enter(Mode::apart, EventKind::release);
  } else if (slipping && x.s.edge > 0) {
    return go_over(x);
  } else if (slipping && (x.undamped() ? x.s.friction >= 0 : x.s.friction > 0)) {
    stick_again(x);
  } else if (x.mode == Mode::stick && x.s.friction > 0) {
    break_away(x);
  } else {
    return false;
  }
  return true;
}

void Contacts::settle_slot(std::size_t slot, Settling& now) {
  Modes& modes = now.modes;
  if (!modes.exists[slot]) return;
  const std::size_t pad = std::size_t(layout_.pad_of[slot]);
  Slot x{slot,
         layout_.pads[pad],
         elements_[pad],
         *surfaces_[layout_.id[slot].body],
         modes.mode[slot],
         modes.hold[slot],
         now.anchors.col(Eigen::Index(slot)),
         place(slot, now.t, now.motions, modes.p_P[slot])};
  look(x);
  const double before = x.stored();
  int changes = 0;
  for (; changes < most_changes && change(x, now); ++changes) look(x);
  if (changes == most_changes) throw CannotAdvance(describe(int(slot)) + ": its mode does not settle");
  modes.touching[pad] += int(x.mode != Mode::apart) - int(modes.mode[slot] != Mode::apart);
  modes.mode[slot] = x.mode;
  modes.hold[slot] = x.hold;
  now.anchors.col(Eigen::Index(slot)) = x.anchor;
  now.dissipated += before - x.stored();
  for (const EventKind kind : x.news) now.changes.push_back({int(slot), kind});
}

/// Seeds or drops the patch of a phalanx; the new samples are apart, their touch is a matter of settle_slot.
bool Contacts::settle_pad(std::size_t index, Settling& now) {
  const Pad& pad = layout_.pads[index];
  const bool exists = now.modes.exists[std::size_t(pad.first)];
  const bool lost = !pad.given && exists && !live(pad, now.modes);
  if (!lost && !(nearness(index, now.t, now.motions, now.modes) > 0)) return false;
  Patch patch;
  if (!exists) {
    const PhalanxShape shape = scene_.hands[std::size_t(pad.hand)].motion->model().shape(pad.carrier);
    const Pose X_OP = pose_in_body(pad, now.t, now.motions);
    const VoxelField& field = *scene_.bodies[std::size_t(pad.body)].field;
    patch = seed_patch(pad.carrier, X_OP, nearest(shape, X_OP, field), scene_.patch);
  }
  for (int i = 0; i < pad.count; ++i) {
    now.modes.exists[std::size_t(pad.first + i)] = i < patch.count;
    if (i < patch.count) now.modes.p_P[std::size_t(pad.first + i)] = patch.p_P[std::size_t(i)];
  }
  return true;
}

void Contacts::settle_samples(std::size_t index, Settling& now) {
  const Pad& pad = layout_.pads[index];
  if (pad.given && now.modes.touching[index] == 0 && (!live(pad, now.modes) || far(pad, now.t, now.motions) > 0))
    return;
  for (int i = 0; i < pad.count; ++i) settle_slot(std::size_t(pad.first + i), now);
}

void Contacts::settle(Settling& now) {
  // Positions and velocities are given, so no sample's change can make another's due: one pass is enough, with the
  // patches after the samples (all apart: dropped) and the samples of new patches once more.
  for (std::size_t pad = 0; pad < layout_.pads.size(); ++pad) {
    settle_samples(pad, now);
    if (settle_pad(pad, now)) settle_samples(pad, now);
  }
}

void Contacts::clear(Modes& modes) const {
  const std::size_t n = layout_.id.size();
  modes.mode.assign(n, Mode::apart);
  modes.hold.assign(n, Foothold());
  modes.p_P = layout_.given_p_P;
  modes.exists.assign(n, 0);
  modes.touching.assign(layout_.pads.size(), 0);
  modes.present.assign(scene_.hands.size(), 0);
  modes.held.assign(scene_.bodies.size(), 0);
}

void Contacts::start(const Motions& motions, Modes& modes, Anchors& anchors) {
  clear(modes);
  const std::size_t n = layout_.id.size();
  for (std::size_t h = 0; h < scene_.hands.size(); ++h) modes.present[h] = present_after(int(h), 0);
  anchors = Anchors::Zero(3, Eigen::Index(n));
  for (std::size_t slot = 0; slot < n; ++slot) {
    const std::size_t index = std::size_t(layout_.pad_of[slot]);
    const Pad& pad = layout_.pads[index];
    modes.exists[slot] = pad.given;
    const SampleStart* start = layout_.start[slot];
    if (!start || !live(pad, modes)) continue;  // settle lets it touch with zero lag
    const Sample s = place(slot, 0, motions, modes.p_P[slot]);
    const Surface& surface = *surfaces_[std::size_t(pad.body)];
    if (!(surface.value(s.p_O) < -touch_depth)) continue;
    const Vector3d lag_O = motions[std::size_t(pad.body)].R.transpose() * start->lag_W;
    const Foot foot = surface.foot(s.p_O - lag_O);
    Vector3d anchor = foot.p_O;
    const bool has_direction = tangential(lag_O, foot.n_O).norm() > 0;
    const Vector3d direction = has_direction ? lag_O : s.v_O;
    const bool slips = start->slipping && !foot.hold.caught();
    if (slips && elements_[index].damping == 0)
      anchor = with_lag(slot, s.p_O, anchor, foot.hold, direction, elements_[index].friction.mu_dynamic, 0);
    modes.mode[slot] = slips ? Mode::slip : Mode::stick;
    modes.hold[slot] = foot.hold;
    ++modes.touching[index];
    anchors.col(Eigen::Index(slot)) = anchor;
  }
}

}  // namespace handhold::reference
