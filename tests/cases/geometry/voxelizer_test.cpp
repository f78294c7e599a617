// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/voxelizer.hpp"

#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "cases/geometry/scanline.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"
#include "tests/cases/geometry/brute_force.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

VoxelOptions size(double h, double band = 0) {
  VoxelOptions options;
  options.voxel_size = h;
  options.band = band;
  return options;
}

Vector3i random_node(const Grid& grid, std::mt19937& random) {
  const auto below = [&random](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); };
  return {below(grid.size.x()), below(grid.size.y()), below(grid.size.z())};
}

// 60 x 40 x 20 voxels, counted: sides that are multiples of h are filled exactly.
TEST(Voxelize, BoxOfWholeVoxelsHasExactlyItsVolume) {
  EXPECT_EQ(voxelize(make_box({0.06, 0.04, 0.02}), size(0.001))->occupied_count(), 60u * 40 * 20);
  EXPECT_EQ(voxelize(make_box({0.06, 0.04, 0.02}), size(0.002))->occupied_count(), 30u * 20 * 10);
  EXPECT_EQ(voxelize(make_box({0.009, 0.015, 0.021}), size(0.003))->occupied_count(), 3u * 5 * 7);
  const auto l_shape = voxelize(make_l_shape(0.08, 0.06, 0.02, 0.03), size(0.001));
  EXPECT_EQ(l_shape->occupied_count(), (80u * 20 + 20 * 40) * 30);
}

// Second order for faces askew to the grid (midpoint rule): 0.3 % at 64 voxels a side leaves room for its scatter.
TEST(Voxelize, VolumeOfTurnedShapesIsNear) {
  for (const ShapeKind& kind : shape_kinds()) {
    const Mesh mesh = brute::turned(make_shape(kind.name));
    const double h = brute::bounds(mesh).sizes().maxCoeff() / 64;
    const auto field = voxelize(mesh, size(h, 2 * h));
    const double volume = static_cast<double>(field->occupied_count()) * h * h * h;
    EXPECT_NEAR(volume / solid_properties(mesh).volume, 1, 0.01) << kind.name;
  }
}

TEST(Voxelize, LeavesRoomAroundTheMesh) {
  const auto field = voxelize(make_sphere(0.02, 3), size(0.001, 0.0045));
  const Grid& grid = field->grid();
  const Vector3d low = field->bounds().min() - grid.origin;
  const Vector3d high = grid.node(grid.size.x() - 1, grid.size.y() - 1, grid.size.z() - 1) - field->bounds().max();
  EXPECT_GE(std::min(low.minCoeff(), high.minCoeff()), 0.0045 + 2 * 0.001 - 1e-12);
}

TEST(Voxelize, DefaultsFollowTheLongestSide) {
  EXPECT_DOUBLE_EQ(voxelize(make_box({0.128, 0.1, 0.01}))->grid().spacing, 0.001);
  EXPECT_DOUBLE_EQ(voxelize(make_box({0.02, 0.01, 0.01}))->grid().spacing, 0.0005);
  EXPECT_DOUBLE_EQ(voxelize(make_box({0.3, 0.01, 0.01}))->grid().spacing, 0.0015);
  EXPECT_DOUBLE_EQ(voxelize(make_box({0.3, 0.01, 0.01}))->band(), 12 * 0.0015);
  EXPECT_DOUBLE_EQ(voxelize(make_box({0.02, 0.01, 0.01}), size(0.0002))->band(), 0.004);
}

// Against every triangle in long double. 2e-9: half a unit of a float at the 18 mm band, doubled by the square root's
// input.
TEST(Voxelize, BandDistanceEqualsBruteForce) {
  std::mt19937 random(7);
  for (const ShapeKind& kind : shape_kinds()) {
    for (const bool askew : {false, true}) {
      const Mesh mesh = askew ? brute::turned(make_shape(kind.name)) : make_shape(kind.name);
      const double h = brute::bounds(mesh).sizes().maxCoeff() / 40;
      const auto field = voxelize(mesh, size(h, 5 * h));
      const Grid& grid = field->grid();
      for (int sample = 0; sample < 300; ++sample) {
        const Vector3i n = random_node(grid, random);
        const double exact = std::min(brute::distance(mesh, grid.node(n.x(), n.y(), n.z())), field->band());
        const double stored = field->data().distance[grid.index(n.x(), n.y(), n.z())];
        const double sign = field->occupied(n.x(), n.y(), n.z()) ? -1 : 1;
        ASSERT_NEAR(stored, sign * exact, 1e-7 * field->band()) << kind.name << " at node " << n.transpose();
      }
    }
  }
}

// Long needles, whose normals are noise: 1e-7 of a length of 5 cm wide.
TEST(Voxelize, NeedlesDoNotSpoilTheBand) {
  Mesh box = make_box({0.05, 0.03, 0.02});
  // Split face 0, 4, 6 by a point a hair off its long diagonal: two slivers and the rest.
  const Vector3d a = box.vertices[0], b = box.vertices[6], c = box.vertices[4];
  box.vertices.push_back((a + b) / 2 + 1e-7 * (c - (a + b) / 2));
  box.triangles[0] = {0, 4, 8};
  box.triangles.push_back({4, 6, 8});
  box.triangles.push_back({0, 8, 6});
  const auto field = voxelize(box, size(0.001, 0.004));
  std::mt19937 random(3);
  const Grid& grid = field->grid();
  for (int sample = 0; sample < 20000; ++sample) {
    const Vector3i n = random_node(grid, random);
    const double exact = std::min(brute::distance(box, grid.node(n.x(), n.y(), n.z())), field->band());
    ASSERT_NEAR(std::abs(field->data().distance[grid.index(n.x(), n.y(), n.z())]), exact, 1e-7 * field->band());
  }
}

// --- ties ------------------------------------------------------------------------------------------------------------

// Kuhn's partition of a cube of m³ cells into 6 m³ tetrahedra: their corners, faces and edges pass exactly through
// nodes.
std::vector<Mesh> kuhn_partition(int m, const Eigen::Matrix3d& shape, const Vector3d& offset) {
  std::vector<Mesh> tetrahedra;
  const int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int cell = 0; cell < m * m * m; ++cell) {
    for (const auto& order : orders) {
      Vector3d p(cell % m, cell / m % m, cell / (m * m));
      Mesh mesh;
      mesh.vertices.push_back(shape * p + offset);
      for (const int axis : order) {
        p += Vector3d::Unit(axis);
        mesh.vertices.push_back(shape * p + offset);
      }
      mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
      if (solid_properties(mesh).volume < 0) {
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
      }
      tetrahedra.push_back(mesh);
    }
  }
  return tetrahedra;
}

// Every node belongs to at most one piece, and the pieces together hold exactly the nodes of the whole.
void expect_partition(const std::vector<Mesh>& pieces, const Mesh& whole, const Grid& grid) {
  std::vector<int> count(grid.count(), 0);
  for (const Mesh& piece : pieces) {
    const auto bits = rasterise(piece, grid);
    for (std::size_t n = 0; n < grid.count(); ++n) count[n] += int(bits[n >> 6] >> (n & 63) & 1);
  }
  const auto bits = rasterise(whole, grid);
  std::size_t wrong = 0;
  for (std::size_t n = 0; n < grid.count(); ++n) wrong += count[n] != int(bits[n >> 6] >> (n & 63) & 1);
  EXPECT_EQ(wrong, 0u);
}

TEST(Rasterise, SharesOutNodesOnSharedFaces) {
  Eigen::Matrix3d sheared;
  sheared << 1, 0.5, 0.25, 0, 1, -0.5, 0, 0, 1;
  for (const double scale : {1.0, std::ldexp(1, -10), std::ldexp(1, 40)}) {
    for (const Eigen::Matrix3d& shape : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), sheared}) {
      Mesh whole = make_box({4, 4, 4});
      for (Vector3d& v : whole.vertices) v = scale * shape * (v + Vector3d::Constant(2));
      const auto pieces = kuhn_partition(4, scale * shape, Vector3d::Zero());
      // Nodes every half unit: half of them lie on corners, edges or faces of the tetrahedra.
      expect_partition(pieces, whole, {scale * Vector3d(-4, -4, -1), scale * 0.5, {24, 24, 12}});
    }
  }
}

// A box [0, 4]³ with nodes at whole numbers: each axis keeps one end of its two, whatever the triangulation.
TEST(Rasterise, AlignedBoxIsHalfOpen) {
  Mesh box = make_box({4, 4, 4});
  for (Vector3d& v : box.vertices) v += Vector3d::Constant(2);
  const Grid grid{Vector3d::Constant(-2), 1, {9, 9, 9}};
  std::size_t count = 0;
  for (const std::uint64_t word : rasterise(box, grid)) count += static_cast<std::size_t>(__builtin_popcountll(word));
  EXPECT_EQ(count, 64u);
}

// Overlapping boxes are one solid, not a hole where they overlap; a cavity (turned inward) is one.
TEST(Rasterise, CountsWindings) {
  const auto shell = [](double side, bool inward) {
    Mesh box = make_box(Vector3d::Constant(side));
    for (auto& t : box.triangles) {
      if (inward) std::swap(t[1], t[2]);
    }
    return box;
  };
  const auto join = [](Mesh a, const Mesh& b) {
    const int shift = static_cast<int>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    return a;
  };
  EXPECT_EQ(voxelize(join(shell(0.02, false), shell(0.01, true)), size(0.001))->occupied_count(), 8000u - 1000);
  EXPECT_EQ(voxelize(join(shell(0.02, false), shell(0.01, false)), size(0.001))->occupied_count(), 8000u);
}

// --- wrong input -----------------------------------------------------------------------------------------------------

std::string message(Mesh mesh, const VoxelOptions& options = {}) {
  try {
    (void)voxelize(std::move(mesh), options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Voxelize, RejectsWhatIsNoSolid) {
  const Mesh box = make_box({0.06, 0.04, 0.02});
  Mesh open = box;
  open.triangles.pop_back();
  EXPECT_EQ(
      message(open),
      "mesh with 3 open and 0 inconsistently oriented edges: the surface must be closed and oriented (import_mesh "
      "repairs what can be repaired)");
  Mesh flipped = box;
  std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
  EXPECT_NE(message(flipped).find("3 inconsistently oriented"), std::string::npos);
  Mesh inside_out = box;
  for (auto& t : inside_out.triangles) std::swap(t[0], t[1]);
  EXPECT_NE(message(inside_out).find("counter-clockwise"), std::string::npos);
  Mesh nan = box;
  nan.vertices[3].y() = NAN;
  EXPECT_EQ(message(nan), "mesh vertex 3: coordinates must be finite (correct the mesh)");
  Mesh index = box;
  index.triangles[5][1] = 8;
  EXPECT_EQ(message(index), "mesh triangle 5: vertex 8 does not exist, there are 8 (indices start at 0)");
  EXPECT_NE(message({}).find("at least 4"), std::string::npos);
}

TEST(Voxelize, RejectsUnfitOptions) {
  const Mesh box = make_box({0.06, 0.04, 0.02});
  EXPECT_NE(message(box, size(-1)).find("voxel_size=-1"), std::string::npos);
  EXPECT_NE(message(box, size(NAN)).find("voxel_size=nan"), std::string::npos);
  EXPECT_NE(message(box, size(1e-6)).find("(take voxels of "), std::string::npos);
  EXPECT_NE(message(box, size(0.001, INFINITY)).find("band=inf"), std::string::npos);
  Mesh away = box;
  for (Vector3d& v : away.vertices) v.x() += 1e6;
  EXPECT_NE(message(away).find("too far"), std::string::npos);
}

// A box of 60 mm whose file is in another unit, and one that is large indeed: the size that is named is taken.
TEST(Voxelize, NamesTheUnitThatIsLikely) {
  EXPECT_NE(message(make_box({60, 40, 20})).find("(is it in millimetres? --scale 0.001)"), std::string::npos);
  EXPECT_NE(message(make_box({6, 4, 2})).find("(is it in centimetres? --scale 0.01; otherwise take"),
            std::string::npos);
  const std::string text = message(make_box({1.5, 1, 1})), start = "(take voxels of ";
  ASSERT_NE(text.find(start), std::string::npos) << text;
  const double millimetres = std::stod(text.substr(text.find(start) + start.size()));
  EXPECT_EQ(message(make_box({1.5, 1, 1}), size(1e-3 * millimetres)), "accepted");
}

}  // namespace
}  // namespace handhold
