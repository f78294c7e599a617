// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Only for files named simbody_*.cpp: this header includes Simbody.

#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Simbody.h>

namespace handhold::reference::simbody {

/// Throws std::logic_error unless Simbody's library was built with our NDEBUG: its State has members under #ifndef
/// NDEBUG, and mixing the two corrupts memory.
void check_library();

[[nodiscard]] std::string version();

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

}  // namespace handhold::reference::simbody
