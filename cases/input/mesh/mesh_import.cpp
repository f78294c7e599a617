// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/mesh_import.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "cases/geometry/wall_thickness.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// Mass properties of the voxels as points at their centres. A cube's own inertia is left out: it would bias what is
// otherwise a midpoint rule.
SolidProperties count_voxels(const VoxelField& field) {
  const Grid& grid = field.grid();
  double count = 0;
  Vector3d first = Vector3d::Zero();
  Matrix3d second = Matrix3d::Zero();
  const Vector3d middle = grid.origin + 0.5 * grid.spacing * (grid.size.cast<double>() - Vector3d::Ones());
  for (int k = 0; k < grid.size.z(); ++k) {
    for (int j = 0; j < grid.size.y(); ++j) {
      for (int i = 0; i < grid.size.x(); ++i) {
        if (!field.occupied(i, j, k)) continue;
        const Vector3d x = grid.node(i, j, k) - middle;
        count += 1;
        first += x;
        second += x * x.transpose();
      }
    }
  }
  SolidProperties result;
  if (count == 0) return result;
  const double cube = std::pow(grid.spacing, 3);
  const Matrix3d covariance = cube * (second - first * first.transpose() / count);
  result.volume = cube * count;
  result.center = middle + first / count;
  result.inertia = covariance.trace() * Matrix3d::Identity() - covariance;
  return result;
}

double surface_area(const Mesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm() / 2;
  return area;
}

void add_warnings(VoxelReport& report, const Mesh& mesh) {
  const double h = report.voxel_size;
  // The worst that sampling can do to a sound solid: half a voxel too many or too few under every face.
  const double explained = 0.5 * h * surface_area(mesh) / report.polyhedron.volume;
  if (!(std::abs(report.volume_difference) <= std::min(0.05, explained))) {
    report.warnings.push_back(
        fmt::format("voxels enclose {:+.2f} % of the surface's volume: smaller voxels, or a mesh that overlaps itself",
                    100 * report.volume_difference));
  }
  if (report.repair.intersecting_pairs > 0) report.warnings.push_back(report.repair.confidence);
  if (report.thinnest_wall < 3 * h) {
    report.warnings.push_back(
        fmt::format("walls about {:.2g} mm thin are less than 3 voxels: take a voxel size of {:.2g} mm",
                    1e3 * report.thinnest_wall, 1e3 * report.thinnest_wall / 3));
  }
  if (report.triangles > 50'000)
    report.warnings.push_back(
        fmt::format("{} triangles: above 50000 queries slow down, simplify the mesh", report.triangles));
}

}  // namespace

ImportedMesh import_mesh(const std::filesystem::path& file, double scale) {
  return import_mesh(read_mesh_file(file), scale);
}

ImportedMesh import_mesh(const MeshFile& file, double scale) {
  const auto start = Clock::now();
  ImportedMesh result;
  result.source = file.path.string();
  result.scale = scale;
  result.mesh = read_mesh(file, scale, &result.warnings);
  try {
    result.repair = repair(result.mesh);
  } catch (const InputError& error) {
    throw InputError(file.path.string() + ": " + error.what());
  }
  result.seconds = seconds_since(start);
  return result;
}

VoxelReport describe(const ImportedMesh& imported, const VoxelField& field, double voxelize_seconds) {
  VoxelReport report;
  report.source = imported.source;
  report.triangles = field.mesh().triangles.size();
  report.size = field.bounds().sizes();
  report.voxel_size = field.grid().spacing;
  report.band = field.band();
  report.nodes = field.grid().count();
  report.voxels = field.occupied_count();
  report.polyhedron = solid_properties(field.mesh());
  report.counted = count_voxels(field);
  report.volume_difference = report.counted.volume / report.polyhedron.volume - 1;
  const Matrix3d difference = report.counted.inertia - report.polyhedron.inertia;
  report.inertia_difference = difference.cwiseAbs().maxCoeff() / report.polyhedron.inertia.cwiseAbs().maxCoeff();
  report.thinnest_wall = thinnest_wall(field);
  report.repair = imported.repair;
  report.warnings = imported.warnings;
  report.seconds = imported.seconds + voxelize_seconds;
  add_warnings(report, field.mesh());
  return report;
}

std::shared_ptr<const VoxelField> level_of_detail(const VoxelField& field, double factor) {
  if (!(factor > 0) || !std::isfinite(factor))
    throw InputError(fmt::format("level of detail {}: need a factor above 0 (2 for voxels twice as large)", factor));
  VoxelOptions options;
  options.voxel_size = factor * field.grid().spacing;
  options.band = std::max(field.band(), 3 * options.voxel_size);
  return voxelize(field.mesh(), options);
}

}  // namespace handhold
