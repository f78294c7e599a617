#pragma once

#include <Eigen/Core>

#include "cases/recording.hpp"
#include "cases/scene/scene.hpp"

namespace handhold::realtime {

using Vector6 = Eigen::Matrix<double, 6, 1>;  ///< (linear, angular)
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A rigid body about its centre of mass.
struct RigidBody {
  double mass{};
  Eigen::Vector3d center_O{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d inertia_O{Eigen::Matrix3d::Zero()};
  Mobility mobility{Mobility::free};
  double held_until{};
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
  [[nodiscard]] bool held(double t) const { return t <= held_until; }
};

[[nodiscard]] RigidBody make_rigid_body(const Body& body);

/// Mass matrix about the centre of mass, in W.
[[nodiscard]] Matrix6 mass_matrix(const RigidBody& body);

/// Gravity (0 while a support carries the weight) and, explicitly, the gyroscopic torque −ω × I ω.
[[nodiscard]] Vector6 external_force(const RigidBody& body, const Eigen::Vector3d& gravity);

/// Moves the pose by the velocity (v, w) held for h: x += h v, R = exp(h ω) R (exact for constant spin).
void move(RigidBody& body, const Vector6& velocity, double h);

}  // namespace handhold::realtime
