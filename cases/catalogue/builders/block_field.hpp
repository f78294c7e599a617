// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <Eigen/Core>

#include "cases/model/voxel_field.hpp"

namespace handhold::catalogue {

/// The field of `voxelize(make_box(size), {voxel_size})`. The last few are kept, since many runs are of the same block:
/// whoever asks first voxelizes, on any thread, the others wait for it and share it.
[[nodiscard]] std::shared_ptr<const VoxelField> block_field(const Eigen::Vector3d& size, double voxel_size);

}  // namespace handhold::catalogue
