// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/geometry/mesh_repair.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/input/mesh/mesh_reader.hpp"
#include "cases/model/mass_properties.hpp"
#include "cases/model/mesh.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold {

/// A mesh from a file, closed and oriented.
struct ImportedMesh {
  std::string source{};  ///< path as given
  double scale{1};
  Mesh mesh{};
  RepairReport repair{};
  std::vector<std::string> warnings{};
  double seconds{};  ///< for reading and repairing
};

/// `read_mesh`, then `repair`; throws InputError naming the file.
[[nodiscard]] ImportedMesh import_mesh(const MeshFile& file, double scale = 1);
[[nodiscard]] ImportedMesh import_mesh(const std::filesystem::path& file, double scale = 1);

/// What a user wants to know about an imported object.
struct VoxelReport {
  std::string source{};
  std::size_t triangles{};
  Eigen::Vector3d size{Eigen::Vector3d::Zero()};  ///< of the bounding box [m]
  double voxel_size{};                            ///< [m]
  double band{};                                  ///< [m]
  std::size_t nodes{};                            ///< of the grid
  std::size_t voxels{};                           ///< inside the solid
  SolidProperties polyhedron{};                   ///< exact for the surface
  SolidProperties counted{};                      ///< sum over the voxels' centres
  double volume_difference{};                     ///< counted / polyhedron − 1
  double inertia_difference{};                    ///< largest entry's, relative to the largest entry
  double thinnest_wall{};                         ///< estimate [m]; infinity if none was found
  RepairReport repair{};
  std::vector<std::string> warnings{};
  double seconds{};  ///< for reading, repairing and voxelizing
};

/// Describes `field`, voxelized from `imported.mesh` in `voxelize_seconds`. Warns if the volumes differ by more than
/// voxels of this size explain, if walls are thinner than 3 voxels, and above 50 000 triangles (queries leave the
/// cache).
[[nodiscard]] VoxelReport describe(const ImportedMesh& imported, const VoxelField& field, double voxelize_seconds = 0);

/// The same solid with voxels `factor` (> 0) times as large; the band stays at least as wide.
[[nodiscard]] std::shared_ptr<const VoxelField> level_of_detail(const VoxelField& field, double factor);

}  // namespace handhold
