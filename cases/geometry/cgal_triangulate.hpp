// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace handhold {

struct CutPolygon {
  std::vector<std::array<int, 3>> triangles{};  ///< indices into the polygon's corners, in its sense
  double ambiguity{};  ///< by how much the enclosed volume may change if it is cut another way; 0 if it is planar [m³]
  bool sound{true};    ///< false if it crosses itself: then it is cut as a fan from its first corner
};

/// Cuts a polygon of at least 3 corners into triangles that use all its corners and stay within it, also if it is
/// concave, has collinear corners, or runs to a hole and back. Seen along its normal (Newell's); n log n for n corners.
[[nodiscard]] CutPolygon cut_polygon(const std::vector<Eigen::Vector3d>& corners);

}  // namespace handhold
