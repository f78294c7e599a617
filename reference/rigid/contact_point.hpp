// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "cases/model/rigid_problem.hpp"

namespace handhold::reference::rigid {

/// Motion of the body at an instant, all in W.
struct Motion {
  Eigen::Matrix3d R{};            ///< R_WB
  Eigen::Vector3d p{}, w{}, v{};  ///< place, angular velocity, velocity of the centre of mass
};

[[nodiscard]] Motion motion_of(const BodyState& body);

/// Kinematics of one contact: c the foot or the ball's centre, n = ∇φ there, contact point c − r n.
struct ContactPoint {
  double gap{};       ///< φ(c) − r [m]
  double gap_rate{};  ///< n · (c' − s' − w × (c − s)) [m/s]
  Eigen::Vector3d normal{};
  Eigen::Vector3d arm{};               ///< from the centre of mass to the contact point [m]
  Eigen::Vector3d velocity{};          ///< u = v + ω × arm − surface_velocity, of the body's matter [m/s]
  Eigen::Vector3d slip{};              ///< its tangential part
  Eigen::Vector3d surface_velocity{};  ///< s' + w × (contact point − s), of a surface that turns with w [m/s]
};

[[nodiscard]] ContactPoint contact_point(const RigidSupport& support, double t, const Motion& body);

/// Its time derivatives, with the acceleration a of the centre of mass and the angular acceleration.
struct ContactRates {
  double gap_acceleration{};       ///< φ'': n · (relative acceleration) + qᵀ ∇∇φ q, q the approach [m/s²]
  Eigen::Vector3d acceleration{};  ///< u' [m/s²]
};

[[nodiscard]] ContactRates contact_rates(const RigidSupport& support, double t, const Motion& body,
                                         const Eigen::Vector3d& a, const Eigen::Vector3d& angular_acceleration);

/// Two unit vectors that complete the unit vector n to a right-handed frame.
struct Tangents {
  Eigen::Vector3d a{}, b{};
};

[[nodiscard]] Tangents tangents(const Eigen::Vector3d& n);

}  // namespace handhold::reference::rigid
