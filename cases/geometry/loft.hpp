// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "cases/model/mesh.hpp"

namespace handhold {

/// Corners of one section, counter-clockwise seen against the direction of travel.
using Ring = std::vector<Eigen::Vector3d>;

/// Surface through `rings` (of equal counts), closed by fans around `bottom` (before the first) and `top` (after the
/// last). The two triangles between corners j, j + 1 of rings r, r + 1 are numbers 2 (r n + j) and the next.
[[nodiscard]] Mesh loft(const std::vector<Ring>& rings, const Eigen::Vector3d& bottom, const Eigen::Vector3d& top);

/// Surface through `rings` whose last joins the first: a ring-shaped solid.
[[nodiscard]] Mesh loft_around(const std::vector<Ring>& rings);

/// Circle of `count` corners at height z, the first on +x.
[[nodiscard]] Ring circle(double radius, double z, int count);

/// The corners of `circle` moved along their directions onto a polygon around the axis (star-shaped as seen from there,
/// counter-clockwise); the corner nearest in angle to each corner of the polygon is put there, so that none is cut off.
[[nodiscard]] Ring around_polygon(const std::vector<Eigen::Vector2d>& polygon, double z, int count);

/// Adds the quadrilaterals between two rings of vertex numbers.
void join_rings(Mesh& mesh, const std::vector<int>& from, const std::vector<int>& to);

}  // namespace handhold
