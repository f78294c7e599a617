#pragma once

// Only for files named simbody_*.cpp: this header includes Simbody.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Simbody.h>

#include "reference/rigid/contact_point.hpp"

namespace handhold::reference::rigid::simbody {

inline SimTK::Vec3 to_simbody(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Eigen::Vector3d to_eigen(const SimTK::Vec3& v) { return {v[0], v[1], v[2]}; }

inline SimTK::Rotation to_simbody(const Eigen::Quaterniond& q) {
  const Eigen::Quaterniond unit = q.normalized();
  return SimTK::Rotation(SimTK::Quaternion(unit.w(), unit.x(), unit.y(), unit.z()));
}

inline Eigen::Matrix3d to_eigen(const SimTK::Rotation& R) {
  Eigen::Matrix3d out;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) out(i, j) = R.asMat33()(i, j);
  return out;
}

inline Motion motion_of(const SimTK::Transform& X, const SimTK::SpatialVec& V) {
  return {to_eigen(X.R()), to_eigen(X.p()), to_eigen(V[0]), to_eigen(V[1])};
}

/// A force at the end of `arm`, as a spatial force at the body's origin.
inline SimTK::SpatialVec spatial_force(const Eigen::Vector3d& arm, const Eigen::Vector3d& force) {
  return {to_simbody(arm.cross(force)), to_simbody(force)};
}

}  // namespace handhold::reference::rigid::simbody
