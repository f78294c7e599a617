// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Only for files named simbody_*.cpp: this header includes Simbody.

#include <Simbody.h>

#include "reference/rigid/contact_point.hpp"
#include "reference/simbody_library.hpp"

namespace handhold::reference::rigid::simbody {

using reference::simbody::to_eigen;
using reference::simbody::to_simbody;

inline Motion motion_of(const SimTK::Transform& X, const SimTK::SpatialVec& V) {
  return {to_eigen(X.R()), to_eigen(X.p()), to_eigen(V[0]), to_eigen(V[1])};
}

/// A force at the end of `arm`, as a spatial force at the body's origin.
inline SimTK::SpatialVec spatial_force(const Eigen::Vector3d& arm, const Eigen::Vector3d& force) {
  return {to_simbody(arm.cross(force)), to_simbody(force)};
}

}  // namespace handhold::reference::rigid::simbody
