// What happens to contacts at events: the discrete half of Contacts.

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "reference/contacts.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

constexpr int most_transitions = 8;  // of one sample at one instant: touch, break away and stick again are three

/// A sample that sticks again keeps this far inside its cone, relatively and [m]: on the cone itself, where mu_s = mu_d
/// puts it, its witness would start at zero and the next breakaway would be missed. Far below every tolerance, far
/// above round-off.
constexpr double cone_margin = 1e-12;
constexpr double cone_margin_length = 1e-16;

Vector3d tangential(const Vector3d& v, const Vector3d& n) { return v - v.dot(n) * n; }

}  // namespace

/// The anchor for which the lag is (ratio d − margin) along `direction` (made tangential): fixed point, contracts by κ
/// d.
Vector3d Contacts::with_lag(const Vector3d& p_O, const Vector3d& anchor, const Vector3d& direction, double ratio,
                            double margin) const {
  Vector3d a = surface_.project(anchor);
  for (int i = 0; i < 60; ++i) {
    const Vector3d n = surface_.gradient(a).gradient.normalized();
    const Vector3d r = p_O - a;
    const double depth = -r.dot(n);
    const Vector3d wanted = std::max(0.0, ratio * depth - margin) * tangential(direction, n).normalized();
    const Vector3d error = r + depth * n - wanted;
    if (error.squaredNorm() < 4e-34) break;  // 2e-17 m: round-off
    a = surface_.project(a + error);
  }
  return a;
}

/// Anchor below p, so that the lag is zero; slips at once if it moves sideways faster than the cone opens.
void Contacts::touch(std::size_t slot, const BodyMotion& body, const Sample& s, Mode& mode, Vector3d& anchor) {
  const Foot foot = surface_.foot(s.p_O);
  anchor = foot.p_O;
  mode = Mode::stick;
  Sample sticking = s;
  evaluate_sample(slot, body, mode, anchor, sticking);
  const double mu_s = element_.friction.mu_static;
  if (element_.damping > 0) {
    if (sticking.friction > 0 || mu_s == 0) mode = Mode::slip;
    return;
  }
  // Undamped, at depth 0, the cone has no width: compare rates, d|e|/dt with mu_s dd/dt. Deep, e = 0 is well inside it.
  const Vector3d v_t = tangential(s.v_O, foot.n_O);
  const bool shallow = foot.depth < 10 * touch_depth;
  const bool slips = mu_s == 0 || (shallow && v_t.norm() > mu_s * -s.v_O.dot(foot.n_O));
  if (!slips) return;
  mode = Mode::slip;
  anchor = with_lag(s.p_O, anchor, v_t, element_.friction.mu_dynamic, 0);
}

void Contacts::settle_slot(std::size_t slot, double t, const BodyMotion& body, Modes& modes, Anchors& anchors,
                           std::vector<Transition>& changes, double& dissipated) {
  const bool live = modes.present[std::size_t(layout_.pads[std::size_t(layout_.pad_of[slot])].hand)];
  Mode& mode = modes.mode[slot];
  const auto change_to = [&](Mode next, EventKind kind) {
    mode = next;
    changes.push_back({int(slot), kind});
  };
  const auto stored = [&](const Sample& s) {
    const Response& r = s.response;
    return mode == Mode::apart ? 0 : 0.5 * element_.stiffness * (r.depth * r.depth + r.lag.squaredNorm());
  };
  if (!modes.exists[slot]) return;
  Sample s = place(slot, t, body, modes.p_P[slot]);
  Vector3d anchor = anchors.col(Eigen::Index(slot));
  evaluate_sample(slot, body, mode, anchor, s);
  if (!live && mode != Mode::apart) {
    dissipated += stored(s);
    change_to(Mode::apart, EventKind::release);
  }
  if (!live) return;
  const double before = stored(s);
  const Friction& friction = element_.friction;
  const bool spring_only = element_.damping == 0;
  for (int i = 0; i < most_transitions; ++i) {
    if (mode == Mode::apart) {
      if (!(s.gap > 0)) break;
      Mode next = mode;
      touch(slot, body, s, next, anchor);
      change_to(next, EventKind::touch);
    } else if (s.gap > 0) {
      change_to(Mode::apart, EventKind::release);
    } else if (mode == Mode::stick) {
      if (!(s.friction > 0)) break;
      if (spring_only) anchor = with_lag(s.p_O, anchor, s.response.lag, friction.mu_dynamic, 0);
      change_to(Mode::slip, EventKind::breakaway);
    } else {
      if (!(spring_only ? s.friction >= 0 : s.friction > 0)) break;
      if (spring_only)
        anchor = with_lag(s.p_O, anchor, s.response.lag, friction.mu_dynamic * (1 - cone_margin), cone_margin_length);
      change_to(Mode::stick, EventKind::restick);
    }
    if (i + 1 == most_transitions)
      throw std::logic_error(fmt::format("{}: mode does not settle at t = {:.12g} s", describe(int(slot)), t));
    s.response = Response();
    s.gap = s.friction = -1;
    evaluate_sample(slot, body, mode, anchor, s);
  }
  anchors.col(Eigen::Index(slot)) = anchor;
  dissipated += before - stored(s);
}

/// Seeds or drops the patch of a phalanx; the new samples are apart, their touch is a matter of settle_slot.
bool Contacts::settle_pad(std::size_t pad, double t, const BodyMotion& body, Modes& modes) {
  const Pad& p = layout_.pads[pad];
  const bool exists = modes.exists[std::size_t(p.first)];
  const bool lost = !p.given && exists && !modes.present[std::size_t(p.hand)];
  if (!lost && !(nearness(pad, t, body, modes) > 0)) return false;
  Patch patch;
  if (!exists) {
    const PhalanxShape shape = scene_.hands[std::size_t(p.hand)].motion->model().shape(p.phalanx);
    const Pose X_OP = pose_in_body(pad, t, body);
    patch = seed_patch(p.phalanx, X_OP, nearest(shape, X_OP, *body_.field), scene_.patch);
  }
  for (int i = 0; i < p.count; ++i) {
    modes.exists[std::size_t(p.first + i)] = i < patch.count;
    if (i < patch.count) modes.p_P[std::size_t(p.first + i)] = patch.p_P[std::size_t(i)];
  }
  return true;
}

std::vector<Transition> Contacts::settle(double t, const BodyMotion& body, Modes& modes, Anchors& anchors,
                                         double& dissipated) {
  // The body's state is given and hands are prescribed, so no sample's change can make another's due: one pass is
  // enough, with the patches after the samples (all apart: dropped) and the samples of new patches once more.
  std::vector<Transition> changes;
  for (std::size_t slot = 0; slot < layout_.id.size(); ++slot)
    settle_slot(slot, t, body, modes, anchors, changes, dissipated);
  for (std::size_t pad = 0; pad < layout_.pads.size(); ++pad) {
    if (!settle_pad(pad, t, body, modes)) continue;
    const Pad& p = layout_.pads[pad];
    for (int i = 0; i < p.count; ++i)
      settle_slot(std::size_t(p.first + i), t, body, modes, anchors, changes, dissipated);
  }
  return changes;
}

void Contacts::start(const BodyMotion& body, Modes& modes, Anchors& anchors) {
  const std::size_t n = layout_.id.size();
  modes.mode.assign(n, Mode::apart);
  modes.p_P = layout_.given_p_P;
  modes.exists.assign(n, 0);
  modes.present.resize(scene_.hands.size());
  for (std::size_t h = 0; h < scene_.hands.size(); ++h) modes.present[h] = present_after(int(h), 0);
  anchors = Anchors::Zero(3, Eigen::Index(n));
  for (std::size_t slot = 0; slot < n; ++slot) {
    const Pad& pad = layout_.pads[std::size_t(layout_.pad_of[slot])];
    modes.exists[slot] = pad.given;
    const SampleStart* start = layout_.start[slot];
    if (!start || !modes.present[std::size_t(pad.hand)]) continue;  // settle lets it touch with zero lag
    const Sample s = place(slot, 0, body, modes.p_P[slot]);
    if (!(surface_.value(s.p_O) < -touch_depth)) continue;
    const Vector3d lag_O = body.R_WO.transpose() * start->lag_W;
    const Foot foot = surface_.foot(s.p_O - lag_O);
    Vector3d anchor = foot.p_O;
    const bool has_direction = tangential(lag_O, foot.n_O).norm() > 0;
    const Vector3d direction = has_direction ? lag_O : s.v_O;
    if (start->slipping && element_.damping == 0)
      anchor = with_lag(s.p_O, anchor, direction, element_.friction.mu_dynamic, 0);
    modes.mode[slot] = start->slipping ? Mode::slip : Mode::stick;
    anchors.col(Eigen::Index(slot)) = anchor;
  }
}

}  // namespace handhold::reference
