// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace handhold {

/// A rigid implicit surface in W. Bodies touch it from the side to which its normal points.
struct RigidSurface {
  enum class Kind { plane, sphere, cylinder };

  Kind kind{Kind::plane};
  Eigen::Vector3d point{Eigen::Vector3d::Zero()};       ///< on the plane; the centre; on the axis [m]
  Eigen::Vector3d direction{Eigen::Vector3d::UnitZ()};  ///< outward normal of a plane, axis of a cylinder; any length
  double radius{};                                      ///< of a sphere or cylinder [m], > 0
  bool hollow{false};                                   ///< touched from inside: a bowl, a tube
};

[[nodiscard]] RigidSurface make_plane(const Eigen::Vector3d& point, const Eigen::Vector3d& outward_normal);
[[nodiscard]] RigidSurface make_sphere(const Eigen::Vector3d& center, double radius, bool hollow = false);
[[nodiscard]] RigidSurface make_cylinder(const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double radius,
                                         bool hollow = false);

/// The signed distance φ at a point, and its first two derivatives.
struct Proximity {
  double distance{};            ///< φ [m], negative inside the solid
  Eigen::Vector3d normal{};     ///< ∇φ, unit; zero at a centre or on an axis, where there is none
  Eigen::Matrix3d curvature{};  ///< ∇∇φ [1/m]; zero there too
};

/// At the point x [m]. Exact for all three kinds, so that a ball of radius r touches where φ(centre) = r.
[[nodiscard]] Proximity proximity(const RigidSurface& surface, const Eigen::Vector3d& x);

}  // namespace handhold
