// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model/mesh.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold {

/// Signed distance of every node to the mesh, exact (to the rounding of a float) up to `band` and ±band beyond;
/// negative where `occupied` (from `rasterise`).
[[nodiscard]] std::vector<float> band_distance(const Mesh& mesh, const Grid& grid, double band,
                                               const std::vector<std::uint64_t>& occupied);

}  // namespace handhold
