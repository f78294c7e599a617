// SPDX-License-Identifier: Apache-2.0
#include "realtime/solve/body_step.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "cases/model/defect.hpp"

namespace handhold::realtime {
namespace {

/// What keeps a body of Mobility::translation from turning: no torque does anything to it, to the last bit [kg m²].
constexpr double no_turning = 1e30;

/// Turns a body that flies freely, with spin L, about ω × L until it has the energy T again: a turn at a constant rate
/// takes a spin about no principal axis off the ellipsoid of constant energy, and it would gain some in every step. The
/// turn is of second order in that of the step, `angle`.
void keep_energy(RigidBody& body, const Eigen::Vector3d& L, double T, double angle) {
  constexpr int most = 4;
  constexpr double rounding = 1e-15, slight = 1e-6;  // sine between ω and L
  for (int i = 0; i < most; ++i) {
    const Eigen::Matrix3d R = body.X_WO.R.toRotationMatrix();
    const Eigen::Vector3d w = R * (body.inverse_inertia_O * (R.transpose() * L));
    const double excess = 0.5 * L.dot(w) - T;
    const Eigen::Vector3d axis = w.cross(L);  // dT = (ω × L)·turn
    const double squared = axis.squaredNorm();
    if (std::abs(excess) <= rounding * T || squared <= slight * slight * w.squaredNorm() * L.squaredNorm()) return;
    const Eigen::Vector3d turn = -excess / squared * axis;
    if (turn.squaredNorm() > angle * angle) return;  // no longer small
    body.X_WO.R = (rotation_by(turn) * body.X_WO.R).normalized();
  }
}

}  // namespace

void predict(const RigidBody& body, const Scheme& scheme, const Eigen::Vector3d& gravity, const Load& load, bool held,
             BodyStep& s) {
  s.X_WO = body.X_WO;
  const double reach = scheme.reach(), place = scheme.place();
  const bool spins = place > 0 && body.turns() && !body.w.isZero(0);
  const Eigen::Matrix3d R0 = body.X_WO.R.toRotationMatrix();
  s.R = spins ? (rotation_by(place * body.w) * body.X_WO.R).toRotationMatrix() : R0;
  if (body.turns()) s.turn = rotation_by(scheme.h * body.w);
  s.arm_O = s.R * body.center_O;
  s.center = body.X_WO.p + R0 * body.center_O + place * body.v;
  if (!body.moves()) return;
  s.change.setZero();

  s.held = held;
  s.per_arm = 1 / body.radius;
  s.turns = body.turns();
  s.drag = held ? 1 / support_time : 0;
  s.load << load.force_W, load.torque_W;
  if (!body.turns()) s.load.tail<3>().setZero();
  s.external = s.load;
  if (!held) s.external.head<3>() += DEFECT(weighs_a_thousandth_more, body.mass, 1.001 * body.mass) * gravity;
  s.u0 << body.v, body.w;
  s.momentum << body.mass * body.v, R0 * (body.inertia_O * (R0.transpose() * body.w));
  const double grown = 1 + reach * s.drag;
  s.mass.topLeftCorner<3, 3>().diagonal().setConstant(grown * body.mass);
  s.mass.bottomRightCorner<3, 3>() =
      DEFECT(support_turns_freely, grown, 1.0) * (s.R * body.inertia_O * s.R.transpose());
  s.rest = s.momentum + reach * s.external;
  s.rest.head<3>() -= grown * body.mass * body.v;
  s.rest.tail<3>() -= s.mass.bottomRightCorner<3, 3>() * body.w;
  if (s.turns) return;
  s.rest.tail<3>().setZero();
  s.mass.bottomRightCorner<3, 3>() = no_turning * Eigen::Matrix3d::Identity();
}

Eigen::Vector3d free_change(const RigidBody& body, const BodyStep& step, const Scheme& scheme) {
  if (!body.moves()) return Eigen::Vector3d::Zero();
  return scheme.reach() / body.mass * step.external.head<3>();
}

void move(RigidBody& body, const BodyStep& step, const Scheme& scheme) {
  if (!body.moves()) return;
  const Vector6 u = step.velocity();
  const Eigen::Vector3d center = body.center() + scheme.h * u.head<3>();
  // The momentum at θ h, without what the drag's factor added.
  const Vector6 at_theta =
      step.drag == 0 ? Vector6(step.mass * u) : Vector6(step.mass / (1 + scheme.reach() * step.drag) * u);
  const Vector6 momentum = scheme.theta == 1 ? at_theta : Vector6(2 * at_theta - step.momentum);
  body.v = scheme.theta == 1 ? Eigen::Vector3d(u.head<3>()) : Eigen::Vector3d(2 * u.head<3>() - step.u0.head<3>());
  if (body.turns()) {
    const Eigen::Vector3d turn = scheme.h * u.tail<3>();
    const Eigen::Vector3d L = momentum.tail<3>(), L0 = step.momentum.tail<3>();
    const double T0 = 0.5 * L0.dot(body.w);
    if (!turn.isZero(0)) body.X_WO.R = (rotation_by(turn) * body.X_WO.R).normalized();
    // Where contacts act, they rely on the turn that they were solved with.
    if ((L - L0).norm() <= 1e-13 * L.norm())
      keep_energy(body, L, DEFECT(free_spin_drifts, T0, 1.0001 * T0), turn.norm());
    const Eigen::Matrix3d R = body.X_WO.R.toRotationMatrix();
    body.w = R * (body.inverse_inertia_O * (R.transpose() * momentum.tail<3>()));
  }
  body.X_WO.p = center - body.X_WO.R * body.center_O;
}

}  // namespace handhold::realtime
