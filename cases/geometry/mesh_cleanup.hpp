// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "cases/model/mesh.hpp"

namespace handhold {

/// Joins points nearer than `tolerance` [m] to each other (0: equal ones) and drops points no triangle uses. Returns
/// how many points were joined to another. The order of the triangles stays.
std::size_t weld(Mesh& mesh, double tolerance);

/// Joins points on the borders of the surface, at edges of one face, that are nearer than `tolerance` [m] to each
/// other: closes cracks and changes nothing else. Returns how many points were joined to another.
std::size_t weld_borders(Mesh& mesh, double tolerance);

/// Drops triangles with two equal corners; returns how many.
std::size_t drop_degenerate(Mesh& mesh);

/// Drops triangles that have the same corners as an earlier one, in any order; returns how many.
std::size_t drop_duplicates(Mesh& mesh);

/// As `drop_duplicates`, but as many as face the other way drop each other: of a fin with two sides, or of a wall
/// between two solids, nothing is left. Then also drops the points that no triangle uses any more.
std::size_t cancel_opposite(Mesh& mesh);

struct HoleFilling {
  std::size_t filled{};
  std::size_t left{};         ///< holes that could not be filled
  double uncertain_volume{};  ///< sum of area times diameter over 8 of the patches: a shallow bulge on every hole [m³]
};

/// Puts back single triangles that are missing from an otherwise consistently oriented surface. Unlike a general
/// filling this needs no manifold: two such holes may meet in a corner.
[[nodiscard]] HoleFilling fill_triangular_holes(Mesh& mesh);

}  // namespace handhold
