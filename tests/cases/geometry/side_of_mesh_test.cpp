// SPDX-License-Identifier: GPL-3.0-or-later
// The rasteriser against CGAL's Side_of_triangle_mesh: the sign of every voxel must agree, off the surface.
#include <filesystem>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/input/mesh/mesh_import.hpp"
#include "tests/cases/geometry/brute_force.hpp"
#include "tests/shared_data.hpp"

namespace handhold {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Surface to_surface(const Mesh& mesh) {
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  for (const auto& v : mesh.vertices) points.emplace_back(v.x(), v.y(), v.z());
  for (const auto& t : mesh.triangles) faces.push_back({std::size_t(t[0]), std::size_t(t[1]), std::size_t(t[2])});
  Surface surface;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, surface);
  return surface;
}

#ifdef __SANITIZE_ADDRESS__
constexpr int layer_step = 8;  // CGAL is slow there: with all layers of all shapes it was not done after eight minutes
#else
constexpr int layer_step = 1;
#endif

void expect_no_voxel_differs(const Mesh& mesh, const VoxelField& field) {
  const Surface surface = to_surface(mesh);
  const CGAL::Side_of_triangle_mesh<Surface, Kernel> side_of(surface);
  const Grid& grid = field.grid();
  std::size_t differing = 0, inside = 0;
  for (int k = 0; k < grid.size.z(); k += layer_step) {
    for (int j = 0; j < grid.size.y(); ++j) {
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Vector3d p = grid.node(i, j, k);
        const auto side = side_of(Kernel::Point_3(p.x(), p.y(), p.z()));
        inside += side == CGAL::ON_BOUNDED_SIDE;
        differing += side != CGAL::ON_BOUNDARY && (side == CGAL::ON_BOUNDED_SIDE) != field.occupied(i, j, k);
      }
    }
  }
  EXPECT_EQ(differing, 0u) << "of " << grid.count();
  EXPECT_GT(inside, 1000u / layer_step);  // there is something to differ
}

TEST(SideOfMesh, NoVoxelOfAnyShapeDiffers) {
  for (const ShapeKind& kind : shape_kinds()) {
    for (const bool askew : {false, true}) {
      SCOPED_TRACE(kind.name + (askew ? " askew" : " aligned"));
      const Mesh mesh = askew ? brute::turned(make_shape(kind.name)) : make_shape(kind.name);
      VoxelOptions options;
      options.voxel_size = brute::bounds(mesh).sizes().maxCoeff() / 64;
      options.band = 2 * options.voxel_size;
      expect_no_voxel_differs(mesh, *voxelize(mesh, options));
    }
  }
}

TEST(SideOfMesh, NoVoxelOfRealMeshesDiffers) {
  const std::filesystem::path folder = test::shared_data("meshes");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no folder of real meshes at " << folder;
  for (const char* name : {"mug_grab", "hammer_grab", "toruslarge_grab", "bunny_grab_13cm", "axe_2handed"}) {
    SCOPED_TRACE(name);
    const ImportedMesh imported = import_mesh(folder / (std::string(name) + ".obj"));
    VoxelOptions options;
    options.voxel_size = brute::bounds(imported.mesh).sizes().maxCoeff() / 128;
    options.band = 2 * options.voxel_size;
    expect_no_voxel_differs(imported.mesh, *voxelize(imported.mesh, options));
  }
}

}  // namespace
}  // namespace handhold
