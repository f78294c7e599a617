// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "cases/model/mesh.hpp"

namespace handhold {

/// Points spread over the surface of a closed mesh: corners where three sharp edges meet, unless nearer than 0.15
/// `spacing` to each other; then, at least 0.75 `spacing` from all others, points along sharp edges (a turn of more
/// than 30 degrees) and on the rest of the surface, in the order of the mesh. What one body touches another with: a box
/// whose longest side is `spacing` gets its eight corners and no more.
///
/// Deterministic. Throws InputError for a spacing <= 0, or one so small that more than 255 points are needed.
[[nodiscard]] std::vector<Eigen::Vector3d> surface_samples(const Mesh& mesh, double spacing);

}  // namespace handhold
