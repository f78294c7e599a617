// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace handhold {

/// Triangles in an object's frame O. Counter-clockwise seen from outside, so that face normals point out.
struct Mesh {
  std::vector<Eigen::Vector3d> vertices{};      ///< [m]
  std::vector<std::array<int, 3>> triangles{};  ///< indices into `vertices`
};

}  // namespace handhold
