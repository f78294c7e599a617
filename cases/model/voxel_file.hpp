// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cases/model/voxel_field.hpp"

namespace handhold {

/// What a .hhvox file holds (docs/hhvox.md): a shape, ready to simulate.
struct VoxelFile {
  std::shared_ptr<const VoxelField> field{};
  std::vector<Eigen::Vector3d> samples_O{};  ///< for Body::samples_O; none: the file has none
};

/// The bytes of a .hhvox file. Throws InputError for more than 255 samples.
[[nodiscard]] std::string pack_voxels(const VoxelField& field, const std::vector<Eigen::Vector3d>& samples_O = {});

/// What `pack_voxels` packed. Throws InputError, its sentence beginning with `name`, unless every byte is as written
/// and the shape is consistent: bytes of strangers are safe. Takes memory in proportion to the bytes, whatever they
/// claim.
[[nodiscard]] VoxelFile unpack_voxels(std::string_view bytes, const std::string& name);

/// Throws InputError for a file that cannot be written.
void write_voxel_file(const std::filesystem::path& file, const VoxelField& field,
                      const std::vector<Eigen::Vector3d>& samples_O = {});

/// Throws InputError for a file that cannot be read, and like `unpack_voxels`.
[[nodiscard]] VoxelFile read_voxel_file(const std::filesystem::path& file);

}  // namespace handhold
