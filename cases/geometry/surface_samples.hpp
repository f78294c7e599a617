#pragma once

#include <vector>

#include <Eigen/Core>

#include "cases/geometry/mesh.hpp"

namespace handhold {

/// Points spread over the surface of a closed mesh, at least about `spacing` apart: corners where three sharp edges
/// meet, then points along sharp edges (a turn of more than 30 degrees), then the rest of the surface, in the order of
/// the mesh. What one body touches another with: a box of edge `spacing` gets its eight corners and no more.
///
/// Deterministic. Throws InputError for a spacing <= 0, or one so small that more than 255 points are needed.
[[nodiscard]] std::vector<Eigen::Vector3d> surface_samples(const Mesh& mesh, double spacing);

}  // namespace handhold
