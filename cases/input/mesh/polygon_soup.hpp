// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace handhold {

/// Polygons as a file lists them, in its units, before anything is cut, joined or repaired.
struct PolygonSoup {
  std::vector<Eigen::Vector3d> points{};
  std::vector<int> corners{};           ///< of all polygons one after the other; every one names a point
  std::vector<std::size_t> ends{};      ///< of each polygon, its end in `corners`
  std::size_t dropped{};                ///< points and lines, which enclose nothing
  std::vector<std::string> warnings{};  ///< sentences about the file
};

}  // namespace handhold
