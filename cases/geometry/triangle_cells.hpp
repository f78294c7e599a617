// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/voxel_field.hpp"

namespace handhold {

/// Fills the cell_* members of `data` from its mesh: a grid of cells around the mesh and, for each, the triangles that
/// touch it (separating axes, with 10⁻⁶ of a cell to spare).
///
/// Edge of a cell: three quarters of the median side of a triangle, within 1.5 to 4 mm (1 mm above 50 000 triangles),
/// and never less than 1/200 of the longest extent, so that memory stays bounded.
void build_triangle_cells(VoxelField::Data& data);

}  // namespace handhold
