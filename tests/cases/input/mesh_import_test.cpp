// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/mesh_import.hpp"

#include <filesystem>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/wall_thickness.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"
#include "tests/cases/geometry/brute_force.hpp"
#include "tests/cases/input/mesh_files.hpp"
#include "tests/shared_data.hpp"

namespace handhold {
namespace {

// Volumes of the repository's real meshes as its README states them (six digits).
struct Expected {
  const char* name;
  double volume;
};

void PrintTo(const Expected& expected, std::ostream* out) { *out << expected.name; }

class RealMesh : public testing::TestWithParam<Expected> {};

TEST_P(RealMesh, IsImportedWithItsVolume) {
  const std::filesystem::path file = test::shared_data("meshes/") + GetParam().name + ".obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no real mesh at " << file;
  const ImportedMesh imported = import_mesh(file);
  const auto field = voxelize(imported.mesh);
  const VoxelReport report = describe(imported, *field, 0);
  EXPECT_NEAR(report.polyhedron.volume / GetParam().volume, 1, 1e-5);
  // Voxels of 0.9 to 1.5 mm: the hammer's flat sides along the grid's planes are the worst of them.
  EXPECT_NEAR(report.counted.volume / GetParam().volume, 1, 0.005);
  EXPECT_LT(report.inertia_difference, 0.01);
  EXPECT_TRUE(report.warnings.empty()) << (report.warnings.empty() ? "" : report.warnings.front());
  const std::string name = GetParam().name;
  if (name == "mug_flipped10pct") {
    EXPECT_EQ(imported.repair.faces_flipped, 611u);  // the README's number
    EXPECT_EQ(imported.repair.confidence, "10 % of faces flipped: certain");
  } else if (name == "hammer_holes1pct") {
    EXPECT_EQ(imported.repair.holes_filled, 77u);  // faces removed
  } else if (name != "mug_inside_out") {
    EXPECT_EQ(imported.repair.method, "as given");
  }
}

INSTANTIATE_TEST_SUITE_P(Files, RealMesh,
                         testing::Values(Expected{"mug_grab", 1.81155e-4}, Expected{"hammer_grab", 1.27676e-4},
                                         Expected{"toruslarge_grab", 3.18812e-4},
                                         Expected{"bunny_grab_13cm", 4.36395e-4},
                                         Expected{"mug_inside_out", 1.81155e-4},
                                         Expected{"mug_flipped10pct", 1.81155e-4},
                                         Expected{"hammer_holes1pct", 1.27676e-4}),
                         [](const auto& mesh) { return mesh.param.name; });

TEST(MeshImport, TeapotIsFlaggedAsPiercingItself) {
  const std::filesystem::path file = test::shared_data("meshes/teapot_grab.obj");
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no real mesh at " << file;
  const ImportedMesh imported = import_mesh(file);
  EXPECT_EQ(imported.repair.intersecting_pairs, 11251u);  // the README's number
  EXPECT_NE(imported.repair.confidence.find("11251 pairs"), std::string::npos);
}

TEST(MeshImport, ErrorsOfRepairNameTheFile) {
  const files::Folder folder;
  Mesh cup = make_cup(0.04, 0.09, 0.003);
  cup.triangles.resize(cup.triangles.size() - 96);
  const auto file = folder.write("open.obj", files::obj(cup));
  try {
    (void)import_mesh(file);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find(file.string() + ": mesh: "), 0u) << error.what();
  }
}

ImportedMesh given(const Mesh& mesh) {
  ImportedMesh imported;
  imported.source = "given";
  imported.mesh = mesh;
  imported.repair = repair(imported.mesh);
  return imported;
}

// The voxels' sums are midpoint rules: exact for the volume of an aligned box, V h²/6 below its inertia on the
// diagonal.
TEST(VoxelReport, CountsMassPropertiesOfABox) {
  const double a = 0.06, b = 0.04, c = 0.02, h = 0.002, volume = a * b * c;
  VoxelOptions options;
  options.voxel_size = h;
  const ImportedMesh imported = given(make_box({a, b, c}));
  const VoxelReport report = describe(imported, *voxelize(imported.mesh, options), 1.5);
  EXPECT_EQ(report.voxels, 30u * 20 * 10);
  EXPECT_EQ(report.triangles, 12u);
  EXPECT_NEAR(report.volume_difference, 0, 1e-12);
  EXPECT_LT(report.counted.center.norm(), 1e-15);
  EXPECT_NEAR(report.counted.inertia(0, 0), volume * (b * b + c * c - 2 * h * h) / 12, 1e-12 * volume * a * a);
  EXPECT_NEAR(report.thinnest_wall, c, 1e-9);
  EXPECT_EQ(report.seconds, 1.5);
  EXPECT_TRUE(report.warnings.empty());
}

TEST(VoxelReport, WarnsOfThinWalls) {
  VoxelOptions options;
  options.voxel_size = 0.0015;
  const ImportedMesh cup = given(brute::turned(make_cup(0.04, 0.095, 0.003)));
  const VoxelReport report = describe(cup, *voxelize(cup.mesh, options));
  EXPECT_NEAR(report.thinnest_wall, 0.003, 1e-5);  // a polygon's flat sides, cos(π/96) apart
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_EQ(report.warnings[0], "walls about 3 mm thin are less than 3 voxels: take a voxel size of 1 mm");
}

TEST(VoxelReport, CountsAnOverlapOnce) {
  const Mesh box = make_box({0.06, 0.06, 0.06});
  Mesh two = box;
  for (const auto& v : box.vertices) two.vertices.push_back(v + Eigen::Vector3d(0.031, 0.017, 0.023));
  for (const auto& t : box.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  const ImportedMesh imported = given(two);
  const VoxelReport report = describe(imported, *voxelize(imported.mesh));
  const double once = 2 * 0.06 * 0.06 * 0.06 - 0.029 * 0.043 * 0.037;
  EXPECT_NEAR(solid_properties(imported.mesh).volume / once, 1, 1e-12);
  EXPECT_NEAR(report.counted.volume / once, 1, 0.02);  // sides along the grid's planes: half a voxel of 0.7 mm in 43 mm
  EXPECT_TRUE(report.warnings.empty()) << report.warnings[0];
}

TEST(VoxelReport, WarnsOfASurfaceThatPiercesItself) {  // one piece: nothing that could be united
  Mesh cone;                                           // whose tip was drawn out through its base
  cone.vertices = {{-0.03, -0.03, 0}, {0.03, -0.03, 0}, {0.03, 0.03, 0},
                   {-0.03, 0.03, 0},  {0, 0, 0.01},     {0.1, 0, -0.03}};
  cone.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 5}, {1, 5, 4}, {5, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const ImportedMesh imported = given(cone);
  EXPECT_GT(imported.repair.intersecting_pairs, 0u);
  const VoxelReport report = describe(imported, *voxelize(imported.mesh));
  ASSERT_FALSE(report.warnings.empty());
  EXPECT_NE(report.warnings.back().find("pierce each other"), std::string::npos) << report.warnings.back();
}

TEST(WallThickness, IgnoresSharpEdges) {
  EXPECT_GT(thinnest_wall(*voxelize(make_axe())), 0.002);
  EXPECT_NEAR(thinnest_wall(*voxelize(make_plate_with_hole({0.1, 0.08, 0.012}, 0.02))), 0.012, 1e-6);
}

TEST(LevelOfDetail, ScalesTheVoxels) {
  const auto fine = voxelize(make_pawn());
  const auto rough = level_of_detail(*fine, 2);
  EXPECT_DOUBLE_EQ(rough->grid().spacing, 2 * fine->grid().spacing);
  EXPECT_GE(rough->band(), fine->band());
  const double ratio = 8.0 * static_cast<double>(rough->occupied_count()) / static_cast<double>(fine->occupied_count());
  EXPECT_NEAR(ratio, 1, 0.01);
  EXPECT_THROW((void)level_of_detail(*fine, 0), InputError);
}

}  // namespace
}  // namespace handhold
