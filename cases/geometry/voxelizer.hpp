// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "cases/model/mesh.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold {

struct VoxelOptions {
  double voxel_size{0};  ///< h [m]; 0: clamp(longest side / 128, 0.5 mm, 1.5 mm)
  double band{0};        ///< exact distance up to here on both sides [m]; 0: the larger of 4 mm and 12 h
};

/// Turns a closed, outward-oriented mesh into a VoxelField with exact predicates; throws InputError for one that is not
/// closed (import_mesh repairs), empty, not finite, or too large for the voxel size.
[[nodiscard]] std::shared_ptr<const VoxelField> voxelize(Mesh mesh, const VoxelOptions& options = {});

}  // namespace handhold
