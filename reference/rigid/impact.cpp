// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/impact.hpp"

#include <Eigen/LU>

#include "cases/model/defect.hpp"
#include "cases/model/rotation.hpp"

namespace handhold::reference::rigid {
namespace {

constexpr int sweeps = 100;
constexpr double straight = 1e-9;  // sliding may turn by this part of its speed

Eigen::Matrix3d inverse_inertia(const RigidProblem& problem, const Motion& body) {
  if (problem.mobility == Mobility::translation) return Eigen::Matrix3d::Zero();
  return body.R * problem.inertia.inverse() * body.R.transpose();
}

}  // namespace

Eigen::Matrix3d response(const RigidProblem& problem, const Motion& body, const Eigen::Vector3d& arm) {
  const Eigen::Matrix3d A = cross_matrix(arm);
  return Eigen::Matrix3d::Identity() / problem.mass + A.transpose() * inverse_inertia(problem, body) * A;
}

void strike(const RigidProblem& problem, const Eigen::Vector3d& arm, const Eigen::Vector3d& impulse, Motion& body) {
  body.v += impulse / problem.mass;
  body.w += inverse_inertia(problem, body) * arm.cross(impulse);
}

std::optional<Eigen::Vector3d> plastic_impulse(const RigidProblem& problem, const RigidSupport& support,
                                               const ContactPoint& point, const Motion& body) {
  const Eigen::Matrix3d K = response(problem, body, point.arm);
  const Eigen::Vector3d& n = point.normal;
  const Eigen::Vector3d full = -K.inverse() * point.velocity;
  const double N = n.dot(full);
  if (N >= 0 &&
      (full - N * n).norm() <= DEFECT(blow_sticks_at_mu_d, support.friction.mu_static, support.friction.mu_dynamic) * N)
    return full;
  const double speed = point.slip.norm();
  if (speed == 0) return std::nullopt;
  const Eigen::Vector3d d = point.slip / speed;
  const Eigen::Vector3d direction = n - DEFECT(blow_without_friction, support.friction.mu_dynamic, 0.0) * d;
  const Eigen::Vector3d impulse = -n.dot(point.velocity) / n.dot(K * direction) * direction;
  const Eigen::Vector3d after = point.velocity + K * impulse;
  const double forward = d.dot(after);
  if (n.dot(impulse) < 0 || forward < 0 || (after - forward * d).norm() > straight * speed) return std::nullopt;
  return impulse;
}

void bring_to_rest(const RigidProblem& problem, const std::vector<Rest>& contacts, Motion& body) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const Eigen::Vector3d v = body.v, w = body.w;
    for (const Rest& c : contacts) {
      if (!c.normal && !c.tangential) continue;
      const Eigen::Vector3d& n = c.point.normal;
      const Eigen::Vector3d u = body.v + body.w.cross(c.point.arm) - c.point.surface_velocity;
      const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - n * n.transpose();
      const Eigen::Matrix3d K = response(problem, body, c.point.arm);
      // Impulse within the forbidden directions S only: K restricted to S, the identity elsewhere.
      const Eigen::Matrix3d S =
          (c.normal ? Eigen::Matrix3d(n * n.transpose()) : Eigen::Matrix3d(Eigen::Matrix3d::Zero())) +
          (c.tangential ? across : Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
      const Eigen::Matrix3d restricted = S * K * S + (Eigen::Matrix3d::Identity() - S) / problem.mass;
      strike(problem, c.point.arm, -(restricted.inverse() * (S * u)), body);
    }
    if (body.v == v && body.w == w) return;
  }
}

}  // namespace handhold::reference::rigid
