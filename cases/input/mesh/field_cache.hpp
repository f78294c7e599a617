// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "cases/geometry/voxelizer.hpp"
#include "cases/input/mesh/mesh_import.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold {

struct FieldCacheOptions {
  bool enabled{true};              ///< HANDHOLD_CACHE=off in the environment disables it, too
  std::filesystem::path folder{};  ///< empty: $XDG_CACHE_HOME/handhold, or ~/.cache/handhold
};

/// An object as imported, ready for queries.
struct ImportedObject {
  ImportedMesh mesh{};
  std::shared_ptr<const VoxelField> field{};
  bool from_cache{false};
  double seconds{};  ///< for everything
};

/// `import_mesh` and `voxelize`, or what they gave for the same bytes, scale and options the last time.
///
/// A cache file that is damaged, older or made for other input is ignored and rebuilt; a folder that cannot be written
/// is no error. A glTF's external buffers belong to its bytes.
[[nodiscard]] ImportedObject import_object(const std::filesystem::path& file, double scale = 1,
                                           const VoxelOptions& options = {}, const FieldCacheOptions& cache = {});

/// Folder the options and the environment name; nothing if the cache is off.
[[nodiscard]] std::optional<std::filesystem::path> cache_folder(const FieldCacheOptions& options);

}  // namespace handhold
