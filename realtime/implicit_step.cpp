#include "realtime/implicit_step.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace handhold::realtime {
namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& r) {
  Eigen::Matrix3d m;
  m << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return m;
}

/// Evaluates one element at the body's velocity u; its slope is zero when apart.
ElementForce evaluate(StepSample& sample, const Vector6& u, const Friction& friction) {
  const Eigen::Vector3d v_C = u.head<3>() + u.tail<3>().cross(sample.arm);
  sample.trial = trial(sample.element, v_C);
  ElementForce force;
  if (sample.trial.N > 0)
    force = sample.sliding ? sliding_force(sample.element, sample.trial, friction.mu_dynamic)
                           : sticking_force(sample.element, sample.trial);
  sample.f = force.f;
  sample.tangent = force.tangent;
  return force;
}

/// Adds Gᵀ f to `force` and Gᵀ S G to `slope`, G = [1, −r×].
void accumulate(const Eigen::Vector3d& arm, const ElementForce& element, Vector6& force, Matrix6& slope) {
  const Eigen::Matrix3d r = cross_matrix(arm);
  const Eigen::Matrix3d Sr = element.slope * r;
  force.head<3>() += element.f;
  force.tail<3>() += arm.cross(element.f);
  slope.topLeftCorner<3, 3>() += element.slope;
  slope.topRightCorner<3, 3>() -= Sr;
  slope.bottomLeftCorner<3, 3>() += r * element.slope;
  slope.bottomRightCorner<3, 3>() -= r * Sr;
}

/// Sticking samples outside the static cone start to slide; true if there was one.
bool break_away(std::vector<StepSample>& samples, std::size_t count, const Friction& friction) {
  bool any = false;
  for (std::size_t i = 0; i < count; ++i) {
    StepSample& s = samples[i];
    if (s.sliding || s.trial.N <= 0 || s.trial.t_norm <= friction.mu_static * s.trial.N) continue;
    s.sliding = any = true;
  }
  return any;
}

}  // namespace

SolverReport solve_velocity(const RigidBody& body, const Vector6& external, double drag, double h,
                            const Friction& friction, std::vector<StepSample>& samples, std::size_t count,
                            const SolverOptions& options, Vector6& u) {
  if (!body.moves()) {
    u.setZero();
    for (std::size_t i = 0; i < count; ++i) evaluate(samples[i], u, friction);
    if (break_away(samples, count, friction))
      for (std::size_t i = 0; i < count; ++i) evaluate(samples[i], u, friction);
    return {};
  }
  const Matrix6 M = mass_matrix(body);
  Vector6 u0;
  u0 << body.v, body.w;
  u = u0;
  const bool turns = body.mobility == Mobility::free;
  for (int iteration = 1; iteration <= options.max_iterations; ++iteration) {
    Vector6 force = external;
    Matrix6 slope = Matrix6::Zero();
    double largest = external.norm();
    for (std::size_t i = 0; i < count; ++i) {
      const ElementForce element = evaluate(samples[i], u, friction);
      if (samples[i].trial.N <= 0) continue;
      accumulate(samples[i].arm, element, force, slope);
      largest += element.f.norm();
    }
    Vector6 residual = M * (u - u0 + h * drag * u) - h * force;
    if (!turns) residual.tail<3>().setZero();
    // Angular rows are in N m s: an arm of a metre would make them comparable, objects are smaller, so this is the safe
    // side.
    if (iteration > 1 && residual.norm() <= options.tolerance * (h * largest + (M * u0).norm())) {
      if (!break_away(samples, count, friction)) return {iteration, true};
      continue;
    }
    Matrix6 J = (1 + h * drag) * M + h * slope;
    if (!turns) {
      J.bottomRows<3>().setZero();
      J.bottomRightCorner<3, 3>().setIdentity();
    }
    u -= J.partialPivLu().solve(residual);
  }
  for (std::size_t i = 0; i < count; ++i) evaluate(samples[i], u, friction);
  return {options.max_iterations, false};
}

}  // namespace handhold::realtime
