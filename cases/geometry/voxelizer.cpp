// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/voxelizer.hpp"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cases/geometry/band_distance.hpp"
#include "cases/geometry/mesh_topology.hpp"
#include "cases/geometry/scanline.hpp"
#include "cases/geometry/triangle_cells.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double most_nodes = 1.5e8;        // 600 MB of distances
constexpr double most_spacings_away = 1e6;  // from the origin: leaves ten digits for a node's place within its cell

void check_mesh(const Mesh& mesh) {
  if (mesh.triangles.size() < 4) {
    throw InputError(
        fmt::format("mesh of {} triangles: a solid has at least 4 (give a closed surface)", mesh.triangles.size()));
  }
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].allFinite()) continue;
    throw InputError(fmt::format("mesh vertex {}: coordinates must be finite (correct the mesh)", v));
  }
  const MeshTopology topology = mesh_topology(mesh);
  if (!topology.closed_and_oriented()) {
    throw InputError(
        fmt::format("mesh with {} open and {} inconsistently oriented edges: the surface must be closed and "
                    "oriented (import_mesh repairs what can be repaired)",
                    topology.open_edges, topology.unbalanced_edges - topology.open_edges));
  }
  const double volume = solid_properties(mesh).volume;
  if (!(volume > 0)) {
    throw InputError(fmt::format(
        "mesh of volume {:g} m³: faces must be counter-clockwise seen from outside (import_mesh turns them)", volume));
  }
}

void check_options(const VoxelOptions& options) {
  if (!(options.voxel_size >= 0) || !std::isfinite(options.voxel_size))
    throw InputError(
        fmt::format("voxel_size={}: need a length above 0 in metres (or 0 for the default)", options.voxel_size));
  if (!(options.band >= 0) || !std::isfinite(options.band))
    throw InputError(fmt::format("band={}: need a length above 0 in metres (or 0 for the default)", options.band));
}

// No hand holds what is metres across: then the unit is the likeliest cause.
std::string cure(double across, double h, double nodes) {
  if (across > 20) return "is it in millimetres? --scale 0.001";
  const double fitting = 1.1e3 * h * std::cbrt(nodes / most_nodes);  // a band of whole voxels takes a few more
  const std::string larger = fmt::format("take voxels of {:.2g} mm", fitting);
  return across > 2 ? "is it in centimetres? --scale 0.01; otherwise " + larger : larger;
}

// Voxels share out the bounding box symmetrically: a box whose size is a multiple of h is filled by whole voxels.
Grid make_grid(const Eigen::AlignedBox3d& bounds, double h, double margin) {
  const Eigen::Array3d inner = (bounds.sizes().array() / h - 1e-9).ceil().max(1.0);
  const Eigen::Array3d nodes = inner + 2 * margin;
  if (!(nodes.prod() <= most_nodes)) {
    throw InputError(
        fmt::format("voxel_size={:g} m: a mesh of {:g} x {:g} x {:g} m would need {:.2g} voxels, the limit is {:.2g} "
                    "({})",
                    h, bounds.sizes().x(), bounds.sizes().y(), bounds.sizes().z(), nodes.prod(), most_nodes,
                    cure(bounds.sizes().maxCoeff(), h, nodes.prod())));
  }
  if (!(std::max(bounds.max().cwiseAbs().maxCoeff(), bounds.min().cwiseAbs().maxCoeff()) <= most_spacings_away * h))
    throw InputError(fmt::format("voxel_size={:g} m: the mesh lies too far from its origin (move it nearer)", h));
  const Vector3d half = (nodes - 1) / 2 * h;
  return {bounds.center() - half, h, nodes.cast<int>()};
}

std::size_t count_bits(const std::vector<std::uint64_t>& words) {
  std::size_t count = 0;
  for (const std::uint64_t word : words) count += std::bitset<64>(word).count();
  return count;
}

// Where the grid lies within one spacing, so that the voxels' volume comes near the solid's. Faces along the grid's
// planes can cost a thin part half a voxel otherwise: 2 % of a hammer at 1.5 mm. Axis by axis, the symmetric place
// first.
Vector3d best_phase(const Mesh& mesh, const Eigen::AlignedBox3d& bounds, double h) {
  constexpr double good_enough = 1e-3;
  const double volume = solid_properties(mesh).volume;
  const Grid centred = make_grid(bounds, h, 1);
  const auto error = [&](const Vector3d& phase) {
    Grid grid = centred;
    grid.origin += h * phase;
    return std::abs(static_cast<double>(count_bits(rasterise(mesh, grid))) * h * h * h / volume - 1);
  };
  Vector3d best = Vector3d::Zero();
  double least = error(best);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d start = best;
    for (const double shift : {0.5, 0.25, -0.25, 0.125, -0.125}) {
      if (least < good_enough) return best;
      const Vector3d phase = start + shift * Vector3d::Unit(axis);
      const double tried = error(phase);
      if (tried >= least) continue;
      least = tried;
      best = phase;
    }
  }
  return best;
}

}  // namespace

std::shared_ptr<const VoxelField> voxelize(Mesh mesh, const VoxelOptions& options) {
  check_options(options);
  check_mesh(mesh);
  Eigen::AlignedBox3d bounds;
  for (const auto& triangle : mesh.triangles) {
    for (const int v : triangle) bounds.extend(mesh.vertices[v]);
  }
  const double h =
      options.voxel_size > 0 ? options.voxel_size : std::clamp(bounds.sizes().maxCoeff() / 128, 0.0005, 0.0015);

  VoxelField::Data data;
  data.band = options.band > 0 ? options.band : std::max(0.004, 12 * h);
  // Two nodes beyond the band on every side, and one for the shift.
  data.grid = make_grid(bounds, h, std::ceil(data.band / h) + 3);
  data.grid.origin += h * best_phase(mesh, bounds, h);
  data.occupied = rasterise(mesh, data.grid);
  data.distance = band_distance(mesh, data.grid, data.band, data.occupied);
  data.mesh = std::move(mesh);
  build_triangle_cells(data);
  return std::make_shared<const VoxelField>(std::move(data));
}

}  // namespace handhold
