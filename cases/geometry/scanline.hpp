// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "cases/model/mesh.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold {

/// Occupancy of every node of `grid`, as bits `grid.index(i, j, k)`: winding number of the mesh above 0, exactly.
///
/// Every triangle adds its signed crossing to the rows along x that pierce it; sums along the rows are winding numbers.
/// All signs are exact (floating filter, CGAL beyond it). Nodes that lie on the surface are decided as if every node
/// were moved by (e³, e, e²) for an infinitesimal e > 0, so that solids sharing a face share out its nodes: none twice,
/// none left out. The mesh must be closed (`mesh_topology`), finite, with |coordinates| < 10⁶ spacings.
[[nodiscard]] std::vector<std::uint64_t> rasterise(const Mesh& mesh, const Grid& grid);

}  // namespace handhold
