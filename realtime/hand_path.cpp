// SPDX-License-Identifier: Apache-2.0
#include "realtime/hand_path.hpp"

#include <algorithm>
#include <cmath>

#include "cases/model/rotation.hpp"

namespace handhold::realtime {
namespace {

Eigen::Quaterniond quaternion(const Eigen::Vector3d& turn) {
  const double angle = turn.norm();
  const double scale = angle > 1e-9 ? std::sin(0.5 * angle) / angle : 0.5;
  Eigen::Quaterniond q;
  q.w() = std::cos(0.5 * angle);
  q.vec() = scale * turn;
  return q;
}

/// Cubic from 0 to `step` with these rates at its ends.
Eigen::Vector3d hermite(const Eigen::Vector3d& step, const Eigen::Vector3d& begin, const Eigen::Vector3d& end,
                        double s) {
  return s * s * (3 - 2 * s) * step + s * (1 - s) * ((1 - s) * begin - s * end);
}

/// Rate of the rotation vector `turn` of a phalanx that spins with `spin`, in its own frame: J_r⁻¹(turn) spin to third
/// order. Without it a velocity would jump at frames when the axis turns.
Eigen::Vector3d turn_rate(const Eigen::Vector3d& turn, const Eigen::Vector3d& spin) {
  const Eigen::Vector3d across = turn.cross(spin);
  return spin + 0.5 * across + turn.cross(across) / 12;
}

/// Every number times zero is zero, unless it is not finite: no branch a number.
bool is_finite(const HandFrame& frame) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  Eigen::Vector4d q = Eigen::Vector4d::Zero();
  for (const Pose& X : frame.X_WP) {
    p += 0.0 * X.p;
    q += 0.0 * X.R.coeffs();
  }
  return p.isZero(0) && q.isZero(0);
}

/// Rate at a frame, by backward difference: this step, plus half of what it changed against the last one scaled to the
/// same length.
Eigen::Vector3d rate_at(const Eigen::Vector3d& step, const Eigen::Vector3d& last, double ratio) {
  return step + ratio / (1 + ratio) * (step - ratio * last);
}

}  // namespace

void HandPath::observe(double dt, const HandFrame& frame) {
  is_back_ = false;
  if (!frame.present || !is_finite(frame)) {
    known_ = 0;
    absent_ += dt;
    return;
  }
  is_back_ = known_ == 0 && ever_ && absent_ + dt <= longest_bridge_;
  absent_ = 0;
  ever_ = true;
  known_ = std::min(known_ + 1, 4);
  newest_ = (newest_ + 1) & 3;
  seen_[std::size_t(newest_)] = {dt, frame.X_WP};
}

Eigen::Vector3d HandPath::move(int phalanx, int frames_ago) const {
  const auto i = std::size_t(phalanx);
  return seen(frames_ago).X_WP[i].p - seen(frames_ago + 1).X_WP[i].p;
}

Eigen::Vector3d HandPath::turn(int phalanx, int frames_ago) const {
  const auto i = std::size_t(phalanx);
  return rotation_vector(seen(frames_ago + 1).X_WP[i].R.conjugate() * seen(frames_ago).X_WP[i].R);
}

HandPath::Step HandPath::step(int phalanx) const {
  Step s;
  s.move = s.rate_begin = s.rate_end = move(phalanx, 0);
  s.turn = s.spin_begin = s.spin_end = turn(phalanx, 0);
  if (known_ < 3) return s;
  const double ratio = seen(0).dt / seen(1).dt;  // the last frame of a run may be shorter
  const Eigen::Vector3d last_move = move(phalanx, 1), last_turn = turn(phalanx, 1);
  s.rate_end = rate_at(s.move, last_move, ratio);
  s.spin_end = rate_at(s.turn, last_turn, ratio);
  s.rate_begin = ratio * last_move;
  s.spin_begin = ratio * last_turn;
  if (known_ < 4) return s;
  const double before = seen(1).dt / seen(2).dt;
  s.rate_begin = ratio * rate_at(last_move, move(phalanx, 2), before);
  s.spin_begin = ratio * rate_at(last_turn, turn(phalanx, 2), before);
  return s;
}

Pose HandPath::pose(int phalanx, double fraction) const {
  const auto i = std::size_t(phalanx);
  if (fraction >= 1 || known_ < 2) return seen(0).X_WP[i];  // to the last bit
  const Step s = step(phalanx);
  const Eigen::Vector3d turned = hermite(s.turn, s.spin_begin, turn_rate(s.turn, s.spin_end), fraction);
  return {seen(1).X_WP[i].R * quaternion(turned),
          seen(1).X_WP[i].p + hermite(s.move, s.rate_begin, s.rate_end, fraction)};
}

}  // namespace handhold::realtime
