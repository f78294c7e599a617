#include "realtime/hand_path.hpp"

#include <algorithm>
#include <cmath>

namespace handhold::realtime {
namespace {

/// Rotation vector of a unit quaternion, the short way round.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0 ? -1 : 1;
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2 * sign * q.vec();
  return sign * 2 * std::atan2(sine, sign * q.w()) / sine * q.vec();
}

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

bool is_finite(const HandFrame& frame) {
  return std::all_of(frame.X_WP.begin(), frame.X_WP.end(),
                     [](const Pose& X) { return X.p.allFinite() && X.R.coeffs().allFinite(); });
}

}  // namespace

void HandPath::observe(double dt, const HandFrame& frame) {
  if (!frame.present || !is_finite(frame)) {
    known_ = 0;
    return;
  }
  known_ = std::min(known_ + 1, 3);
  const double ratio = dt_ > 0 ? dt / dt_ : 1;  // the last frame of a run may be shorter
  for (int i = 0; i < phalanx_count; ++i) {
    const Pose& X = frame.X_WP[i];
    const Step last = step_[i];
    Step& step = step_[i];
    begin_[i] = known_ > 1 ? end_[i] : X;
    end_[i] = X;
    step.move = X.p - begin_[i].p;
    step.turn = rotation_vector(begin_[i].R.conjugate() * X.R);
    if (known_ == 1) {
      step = {};
      continue;
    }
    // Backward difference: this step, plus half of what it changed against the last one scaled to the same length.
    const bool second = known_ > 2;
    const double blend = ratio / (1 + ratio);
    step.rate_begin = second ? ratio * last.rate_end : step.move;
    step.rate_end = second ? step.move + blend * (step.move - ratio * last.move) : step.move;
    step.spin_begin = second ? ratio * last.spin_end : step.turn;
    step.spin_end = second ? step.turn + blend * (step.turn - ratio * last.turn) : step.turn;
  }
  dt_ = dt;
}

Pose HandPath::pose(int phalanx, double fraction) const {
  if (fraction >= 1) return end_[phalanx];  // to the last bit
  const Step& step = step_[phalanx];
  const Eigen::Vector3d turn = hermite(step.turn, step.spin_begin, turn_rate(step.turn, step.spin_end), fraction);
  return {begin_[phalanx].R * quaternion(turn),
          begin_[phalanx].p + hermite(step.move, step.rate_begin, step.rate_end, fraction)};
}

}  // namespace handhold::realtime
