// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace handhold {

/// Rigid pose X_AB of a frame B in a frame A: p_A = R p_B + p. R is a unit quaternion, p in metres.
struct Pose {
  Eigen::Quaterniond R{Eigen::Quaterniond::Identity()};
  Eigen::Vector3d p{Eigen::Vector3d::Zero()};  ///< [m]

  /// The point `p_B`, given in B, expressed in A.
  [[nodiscard]] Eigen::Vector3d operator*(const Eigen::Vector3d& p_B) const { return R * p_B + p; }

  /// X_AC = X_AB X_BC.
  [[nodiscard]] Pose operator*(const Pose& X_BC) const { return {R * X_BC.R, R * X_BC.p + p}; }

  /// X_BA.
  [[nodiscard]] Pose inverse() const {
    const Eigen::Quaterniond R_BA = R.conjugate();
    return {R_BA, -(R_BA * p)};
  }
};

/// Velocity of a frame: angular velocity and the velocity of its origin, both expressed in the frame it moves in.
struct Twist {
  Eigen::Vector3d w{Eigen::Vector3d::Zero()};  ///< [rad/s]
  Eigen::Vector3d v{Eigen::Vector3d::Zero()};  ///< [m/s]
};

}  // namespace handhold
