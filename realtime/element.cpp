#include "realtime/element.hpp"

namespace handhold::realtime {

ElementForce sticking_force(const ElementStep& s, const Trial& trial) {
  const double slope = s.h * s.stiffness + s.damping;
  return {-trial.N * s.n + trial.t, trial.t, slope * Eigen::Matrix3d::Identity(), false};
}

ElementForce sliding_force(const ElementStep& s, const Trial& trial, double mu_dynamic) {
  const double cap = mu_dynamic * trial.N;
  if (trial.t_norm <= cap) return sticking_force(s, trial);
  // f = −N n + μ N τ with τ = t*/|t*|; dN/dv_C = slope n·, dt*/dv_C = −slope (1 − n nᵀ).
  const double slope = s.h * s.stiffness + s.damping;
  const Eigen::Vector3d direction = trial.t / trial.t_norm;
  const Eigen::Vector3d tangent = cap * direction;
  const Eigen::Vector3d first = s.n - mu_dynamic * direction;  // −∂f/∂N
  Eigen::Matrix3d d = first * s.n.transpose();
  const Eigen::Matrix3d across =
      Eigen::Matrix3d::Identity() - s.n * s.n.transpose() - direction * direction.transpose();
  d += cap / trial.t_norm * across;
  return {-trial.N * s.n + tangent, tangent, slope * d, true};
}

ElementForce capped_force(const ElementStep& s, const Trial& trial, double cap) {
  const double slope = s.h * s.stiffness + s.damping;
  const Eigen::Matrix3d normal = s.n * s.n.transpose();
  ElementForce force;
  force.slope = Eigen::Matrix3d::Identity() - normal;
  force.tangent = trial.t;
  if (trial.t_norm > cap) {
    const Eigen::Vector3d direction = trial.t / trial.t_norm;
    force.tangent = cap * direction;
    force.slope = cap / trial.t_norm * (force.slope - direction * direction.transpose()).eval();
  }
  force.f = force.tangent;
  if (trial.N > 0) {
    force.f -= trial.N * s.n;
    force.slope += normal;
  }
  force.slope *= slope;
  return force;
}

}  // namespace handhold::realtime
