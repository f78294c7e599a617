// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/voxel_field.hpp"

namespace handhold {

/// Estimate of the thinnest wall of a solid [m]: rays from the middles of up to 2000 triangles straight inward to the
/// opposite side, counted where that is parallel within 20 degrees; the length below which 1 % of the counted area
/// lies, so that a sharp edge does not pass for a wall. Infinity if no two sides face each other.
[[nodiscard]] double thinnest_wall(const VoxelField& field);

}  // namespace handhold
