// SPDX-License-Identifier: Apache-2.0
#include "realtime/contact/element.hpp"

namespace handhold::realtime {

/// f = −N n + s t* with s = 1 (sticking), μ N / |t*| or cap / |t*|; dN/dv_C = slope n·, dt*/dv_C = −slope (1 − n nᵀ).
Eigen::Matrix3d slope_of(const ElementStep& s, const Trial& trial, const Grip& grip) {
  const double slope = s.h * s.stiffness + s.damping;
  if (grip.presses && !grip.slips) return slope * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d normal = s.n * s.n.transpose();
  Eigen::Matrix3d d = Eigen::Matrix3d::Identity() - normal;
  if (grip.slips) {
    const Eigen::Vector3d direction = trial.t / trial.t_norm;
    d = grip.share * (d - direction * direction.transpose()).eval();
    d -= grip.mu * direction * s.n.transpose();
  }
  if (grip.presses) d += normal;
  return slope * d;
}

}  // namespace handhold::realtime
