// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A body in an audited sub-step, and the balances of its momenta.

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "realtime/solve/body_step.hpp"
#include "tests/realtime/audit_tally.hpp"

namespace handhold::realtime::testing {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A body in the step: pose about which all is linearised, velocities before and while it moves, momenta about its
/// centre.
struct AuditedBody {
  bool moves{false}, turns{false};
  Scheme scheme{};
  double mass{}, grown{1};
  Vector3d center_O{Vector3d::Zero()}, center{Vector3d::Zero()};
  Matrix3d R{Matrix3d::Identity()}, inverse_J{Matrix3d::Zero()};
  Vector3d u0{Vector3d::Zero()}, w0{Vector3d::Zero()}, u{Vector3d::Zero()}, w{Vector3d::Zero()};
  Vector3d v1{Vector3d::Zero()};  // at the end
  Vector3d L0{Vector3d::Zero()}, L1{Vector3d::Zero()};
  Vector3d force{Vector3d::Zero()}, torque{Vector3d::Zero()};      // sums of contacts
  Vector3d load{Vector3d::Zero()}, load_torque{Vector3d::Zero()};  // with gravity

  [[nodiscard]] Vector3d at(const Vector3d& p_O) const { return center + R * (p_O - center_O); }
  [[nodiscard]] Vector3d velocity(const Vector3d& p) const { return u + w.cross(p - center); }
  [[nodiscard]] Vector3d velocity_before(const Vector3d& p) const { return u0 + w0.cross(p - center); }
  /// Where a point would be after h, and how the body would have turned, if no velocity changed.
  [[nodiscard]] Eigen::Quaterniond turn_before(double h) const { return rotation_by(h * w0); }
  [[nodiscard]] Vector3d goes_on(const Vector3d& p, double h) const {
    return center + h * u0 + turn_before(h) * (p - center);
  }
  [[nodiscard]] Vector3d change(const Vector3d& p) const { return u - u0 + (w - w0).cross(p - center); }

  [[nodiscard]] Vector3d at_theta(const Vector3d& start, const Vector3d& end) const {
    return scheme.theta == 1 ? end : Vector3d(0.5 * (start + end));
  }

  /// Sizes of the momenta in the balance [N s].
  [[nodiscard]] double size() const { return mass * (u0.norm() + grown * u.norm()) + L0.norm() + grown * L1.norm(); }
  /// P1 − P0 = h (load + contacts) − P_θ h / τ.
  [[nodiscard]] Vector3d linear_residual() const {
    return mass * (v1 - u0 + (grown - 1) * u) - scheme.h * (load + force);
  }
  [[nodiscard]] Vector3d angular_residual() const {
    return L1 - L0 + (grown - 1) * at_theta(L0, L1) - scheme.h * (load_torque + torque);
  }
};

/// What a step of `scheme` made of a body under gravity and `load`; `held`: in its support's oil.
inline AuditedBody audited_body(const RigidBody& before, const RigidBody& after, const Scheme& scheme,
                                const Vector3d& gravity, const Load& load, bool held) {
  AuditedBody m;
  m.moves = before.moves();
  m.turns = before.turns();
  m.scheme = scheme;
  m.mass = before.mass;
  m.center_O = before.center_O;
  const BodyStep step = predict(before, scheme, gravity, load, held);
  m.R = step.R;
  m.center = step.center;
  if (!m.moves) return m;
  if (held) m.grown = 1 + scheme.h / support_time;
  m.u0 = before.v;
  m.w0 = before.w;
  m.u = m.at_theta(before.v, after.v);
  m.v1 = after.v;
  m.load = load.force_W;
  if (!held) m.load += m.mass * gravity;
  m.load_torque = load.torque_W;
  if (!m.turns) return m;
  m.inverse_J = m.R * before.inverse_inertia_O * m.R.transpose();
  m.L0 = before.inertia() * before.w;
  m.L1 = after.inertia() * after.w;
  m.w = m.inverse_J * m.at_theta(m.L0, m.L1);
  return m;
}

}  // namespace handhold::realtime::testing
