// SPDX-License-Identifier: Apache-2.0
#include "cases/model/rigid_surface.hpp"

namespace handhold {

RigidSurface make_plane(const Eigen::Vector3d& point, const Eigen::Vector3d& outward_normal) {
  return {RigidSurface::Kind::plane, point, outward_normal, 0, false};
}

RigidSurface make_sphere(const Eigen::Vector3d& center, double radius, bool hollow) {
  return {RigidSurface::Kind::sphere, center, Eigen::Vector3d::UnitZ(), radius, hollow};
}

RigidSurface make_cylinder(const Eigen::Vector3d& point, const Eigen::Vector3d& axis, double radius, bool hollow) {
  return {RigidSurface::Kind::cylinder, point, axis, radius, hollow};
}

Proximity proximity(const RigidSurface& surface, const Eigen::Vector3d& x) {
  const Eigen::Vector3d direction = surface.direction.normalized();
  Eigen::Vector3d from = x - surface.point;
  if (surface.kind == RigidSurface::Kind::plane) return {direction.dot(from), direction, Eigen::Matrix3d::Zero()};
  // φ = ±(|ρ| − R), ρ the offset from the centre, or across the axis; ∇∇|ρ| = (P − n nᵀ)/|ρ|, P = ∂ρ/∂x.
  Eigen::Matrix3d P = Eigen::Matrix3d::Identity();
  if (surface.kind == RigidSurface::Kind::cylinder) P -= direction * direction.transpose();
  from = P * from;
  const double length = from.norm();
  const double side = surface.hollow ? -1 : 1;
  if (length == 0) return {-side * surface.radius, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  const Eigen::Vector3d out = from / length;
  return {side * (length - surface.radius), side * out, side / length * (P - out * out.transpose())};
}

}  // namespace handhold
