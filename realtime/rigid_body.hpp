// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cases/model/body.hpp"
#include "cases/model/recording.hpp"
#include "cases/model/rotation.hpp"

namespace handhold::realtime {

using Vector6 = Eigen::Matrix<double, 6, 1>;  ///< (linear, angular)
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A rigid body about its centre of mass.
struct RigidBody {
  double mass{};
  Eigen::Vector3d center_O{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d inertia_O{Eigen::Matrix3d::Zero()};
  Eigen::Matrix3d inverse_inertia_O{Eigen::Matrix3d::Zero()};
  Mobility mobility{Mobility::free};
  double held_until{};
  double radius{};  ///< no point of the surface is farther from the centre of mass [m]
  Pose X_WO{};
  Eigen::Vector3d v{Eigen::Vector3d::Zero()};  ///< of the centre of mass, in W [m/s]
  Eigen::Vector3d w{Eigen::Vector3d::Zero()};  ///< in W [rad/s]

  /// Centre of mass, in W.
  [[nodiscard]] Eigen::Vector3d center() const { return X_WO * center_O; }
  /// About the centre of mass, in W.
  [[nodiscard]] Eigen::Matrix3d inertia() const {
    const Eigen::Matrix3d R = X_WO.R.toRotationMatrix();
    return R * inertia_O * R.transpose();
  }
  [[nodiscard]] BodyState state() const { return {X_WO, {w, v + w.cross(X_WO.p - center())}}; }
  [[nodiscard]] bool moves() const { return mobility != Mobility::fixed; }
  [[nodiscard]] bool turns() const { return mobility == Mobility::free; }
  [[nodiscard]] bool held(double t) const { return t <= held_until; }
};

[[nodiscard]] RigidBody make_rigid_body(const Body& body);

/// exp(angle) of a rotation vector.
[[nodiscard]] Eigen::Quaterniond rotation_by(const Eigen::Vector3d& angle);

}  // namespace handhold::realtime
