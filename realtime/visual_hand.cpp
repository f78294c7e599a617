// SPDX-License-Identifier: Apache-2.0
#include "realtime/visual_hand.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "cases/model/input_error.hpp"
#include "cases/model/patch.hpp"
#include "cases/model/rotation.hpp"

namespace handhold::realtime {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Quaterniond rotation(const Vector3d& turn) {
  const double angle = turn.norm();
  return angle < 1e-15 ? Quaterniond::Identity() : Quaterniond(Eigen::AngleAxisd(angle, turn / angle));
}

/// The fraction u of the way from a to b.
Pose between(const Pose& a, const Pose& b, double u) {
  return {rotation(u * rotation_vector(b.R * a.R.conjugate())) * a.R, a.p + u * (b.p - a.p)};
}

/// One step of the critically damped spring, exact.
void decay(double omega, double dt, Vector3d& e, Vector3d& rate) {
  const double fade = std::exp(-omega * dt);
  const Vector3d b = rate + omega * e;
  rate = (b - omega * (e + b * dt)) * fade;
  e = (e + b * dt) * fade;
}

/// The phalanges that a newly touching one takes with it: its finger, or the palm alone.
std::pair<int, int> finger_of(int phalanx) {
  return phalanx == palm ? std::pair{palm, 1} : std::pair{phalanx / 3 * 3, 3};
}

}  // namespace

void validate(const VisualOptions& o) {
  const auto require = [](bool holds, const char* what, double given, const char* rule) {
    if (!holds) throw InputError("visual hand: " + std::string(what) + "=" + std::to_string(given) + ": " + rule);
  };
  const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
  require(positive(o.refine_time), "refine_time", o.refine_time, "must be above 0 s (try 0.08)");
  require(positive(o.release_time), "release_time", o.release_time, "must be above 0 s (try 0.15)");
  require(o.refine_most >= 0, "refine_most", o.refine_most, "must not be negative (try 0.02 m)");
  require(o.linger >= 0, "linger", o.linger, "must not be negative (try 0.04 s)");
}

VisualHand::VisualHand(const VisualOptions& options) : options_(options) { validate(options); }

bool VisualHand::blending(int phalanx) const {
  const Offset& o = state_[std::size_t(phalanx)].offset;
  return o.move.norm() > 1e-4 || o.turn.norm() > 1e-2;
}

VisualHand::Offset VisualHand::difference(const Pose& drawn, const Pose& target) {
  Offset offset;
  offset.move = drawn.p - target.p;
  offset.turn = rotation_vector(drawn.R * target.R.conjugate());
  return offset;
}

Pose VisualHand::target(int phalanx, const VisualInput& input, std::span<const Pose> X_WO) const {
  const State& s = state_[std::size_t(phalanx)];
  return s.body < 0 ? input.X_WP[std::size_t(phalanx)] : X_WO[std::size_t(s.body)] * s.X_OP;
}

/// Where between the last frame (0) and this one (1) the phalanx's skin reached the surface.
double VisualHand::fraction(int phalanx, const PhalanxTouch& touch) const {
  if (!last_.present || touch.depth <= 0) return 1;
  const double before = last_.touch[std::size_t(phalanx)].depth;
  return before < 0 ? before / (before - touch.depth) : 0;
}

/// Tracked pose on the body at that time.
Pose VisualHand::caught(int phalanx, int body, double fraction, const VisualInput& input,
                        std::span<const Pose> X_WO) const {
  const auto i = std::size_t(phalanx), b = std::size_t(body);
  const Pose now = X_WO[b].inverse() * input.X_WP[i];
  if (fraction >= 1 || !last_.present || b >= last_bodies_) return now;
  return between(last_X_WO_[b].inverse() * last_.X_WP[i], now, fraction);
}

void VisualHand::freeze(int first, int count, const VisualInput& input, std::span<const Pose> X_WO) {
  int body = -1;
  double earliest = 2;
  for (int i = first; i < first + count; ++i) {
    const PhalanxTouch& touch = input.touch[std::size_t(i)];
    if (touch.body < 0 || fraction(i, touch) >= earliest) continue;
    earliest = fraction(i, touch);
    body = touch.body;
  }
  for (int i = first; i < first + count; ++i) {
    State& s = state_[std::size_t(i)];
    s.X_OP = caught(i, body, earliest, input, X_WO);
    s.body = body;
  }
}

/// "The hand mesh can still be slightly updated and refined to some degree once other fingers interact."
void VisualHand::refine(int first, int count, const VisualInput& input, std::span<const Pose> X_WO) {
  double earliest = 1;
  for (int i = first; i < first + count; ++i)
    if (input.touch[std::size_t(i)].body >= 0) earliest = std::min(earliest, fraction(i, input.touch[std::size_t(i)]));
  for (int i = first; i < first + count; ++i) {
    State& s = state_[std::size_t(i)];
    const Pose wanted = caught(i, s.body, earliest, input, X_WO);
    const double way = (wanted.p - s.X_OP.p).norm();
    const Pose before = X_WO[std::size_t(s.body)] * s.X_OP;
    s.X_OP = between(s.X_OP, wanted, way > options_.refine_most ? options_.refine_most / way : 1);
    const Offset jump = difference(before, X_WO[std::size_t(s.body)] * s.X_OP);
    s.offset.move += jump.move;  // at rest against the object at first, as what was drawn is
    s.offset.turn += jump.turn;
    s.offset.omega = 2 / options_.refine_time;
  }
}

void VisualHand::release(int phalanx, double dt, const VisualInput& input, std::span<const Pose> X_WO) {
  const auto i = std::size_t(phalanx);
  State& s = state_[i];
  const Offset rest = s.offset;
  const Pose stood = X_WO[std::size_t(s.body)] * s.X_OP;
  const Pose drawn{rotation(rest.turn) * stood.R, stood.p + rest.move};
  s.offset = difference(drawn, input.X_WP[i]);
  s.offset.omega = 2 / options_.release_time;
  if (last_.present && dt > 0) {
    const Offset before = difference(drawn_[i], last_.X_WP[i]);
    s.offset.move_rate = (s.offset.move - before.move) / dt;
    s.offset.turn_rate = (s.offset.turn - before.turn) / dt;
  }
  s.body = -1;
}

void VisualHand::update_group(int first, int count, double dt, const VisualInput& input, std::span<const Pose> X_WO) {
  const auto touches = [](const VisualInput& in, int i) { return in.touch[std::size_t(i)].body >= 0; };
  bool any = false;
  for (int i = first; i < first + count; ++i) any |= touches(input, i);
  const bool stands = frozen(first);
  double& untouched = untouched_[std::size_t(first)];
  untouched = any ? 0 : untouched + dt;
  if (!stands) {
    if (any) freeze(first, count, input, X_WO);
    return;
  }
  if (!any && untouched > options_.linger) {
    for (int i = first; i < first + count; ++i) release(i, dt, input, X_WO);
    return;
  }
  for (int i = first; i < first + count;) {
    const auto [finger, size] = finger_of(i);
    bool touched = false, before = false;
    for (int j = finger; j < finger + size; ++j) {
      touched |= touches(input, j) && input.touch[std::size_t(j)].body == state_[std::size_t(j)].body;
      before |= touches(last_, j);
    }
    if (touched && !before && count > size) refine(finger, size, input, X_WO);
    i = finger + size;
  }
}

const std::array<Pose, phalanx_count>& VisualHand::advance(double dt, const VisualInput& given,
                                                           std::span<const Pose> X_WO) {
  VisualInput input = given;
  for (PhalanxTouch& touch : input.touch)
    if (touch.body >= int(std::min(X_WO.size(), most_bodies))) touch.body = -1;  // a body nobody told the pose of
  if (!input.present) {
    state_ = {};
    last_ = {};
    return drawn_;
  }
  // Blends run on; rates are against the target, which moves with the object or the tracker.
  for (State& s : state_) {
    decay(s.offset.omega, dt, s.offset.move, s.offset.move_rate);
    decay(s.offset.omega, dt, s.offset.turn, s.offset.turn_rate);
    if (s.body >= int(X_WO.size())) s.body = -1;
  }
  if (options_.mode == FreezeMode::whole_hand) {
    update_group(0, phalanx_count, dt, input, X_WO);
  } else {
    for (int finger = 0; finger < 5; ++finger) update_group(3 * finger, 3, dt, input, X_WO);
    update_group(palm, 1, dt, input, X_WO);
  }
  for (int i = 0; i < phalanx_count; ++i) {
    const Pose X = target(i, input, X_WO);
    const Offset& o = state_[std::size_t(i)].offset;
    drawn_[std::size_t(i)] = {rotation(o.turn) * X.R, X.p + o.move};
  }
  last_ = input;
  last_bodies_ = std::min(X_WO.size(), most_bodies);
  std::copy_n(X_WO.begin(), last_bodies_, last_X_WO_.begin());
  return drawn_;
}

void keep_out(const HandModel& model, const VoxelField& field, const Pose& X_WO, double bound,
              std::array<Pose, phalanx_count>& poses) {
  constexpr int tries = 32;  // one is enough on a plane; walls at 60 degrees halve the excess each time
  const Pose X_OW = X_WO.inverse();
  for (int i = 0; i < phalanx_count; ++i) {
    Pose& X_WP = poses[std::size_t(i)];
    for (int k = 0; k < tries; ++k) {
      const Pose X_OP = X_OW * X_WP;
      const Nearest place = nearest(model.shape(i), X_OP, field);
      const double excess = -place.distance - bound;
      if (!(excess > 0)) break;
      X_WP.p += X_WO.R * (excess * place.n_O);
    }
  }
}

}  // namespace handhold::realtime
