// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cases/model/mesh.hpp"

namespace handhold {

/// Volume, centre and inertia of a solid of uniform unit density (1 kg/m³), from its surface.
struct SolidProperties {
  double volume{};                                   ///< [m³]
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};   ///< centre of volume in the mesh's frame [m]
  Eigen::Matrix3d inertia{Eigen::Matrix3d::Zero()};  ///< about `center`, at 1 kg/m³ [m⁵]
};

/// Exact volume integrals of a closed, outward-oriented polyhedron by the divergence theorem (long double, centred).
/// Meaningless for an open or self-overlapping mesh: `repair` tells.
[[nodiscard]] SolidProperties solid_properties(const Mesh& mesh);

}  // namespace handhold
