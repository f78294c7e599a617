// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/shapes.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "cases/geometry/cgal_repair.hpp"
#include "cases/geometry/mesh_topology.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/mass_properties.hpp"
#include "tests/cases/geometry/brute_force.hpp"

namespace handhold {
namespace {

class EveryShape : public testing::TestWithParam<std::string> {};

TEST_P(EveryShape, IsAClosedOutwardManifoldAroundItsCentre) {
  const Mesh mesh = make_shape(GetParam());
  const MeshTopology topology = mesh_topology(mesh);
  EXPECT_EQ(topology.open_edges, 0u);
  EXPECT_EQ(topology.non_manifold_edges, 0u);
  EXPECT_EQ(topology.clashing_edges, 0u);
  EXPECT_EQ(topology.components, 1u);
  EXPECT_TRUE(is_manifold(mesh));
  EXPECT_EQ(count_self_intersections(mesh), 0u);  // CGAL's exact predicates
  const SolidProperties p = solid_properties(mesh);
  EXPECT_GT(p.volume, 0);
  EXPECT_LT(p.center.norm(), 1e-15);  // rounding of coordinates of 0.1 m
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryShape,
                         testing::Values("box", "sphere", "cylinder", "l_shape", "torus", "plate_with_hole", "cup",
                                         "mug", "hammer", "axe", "pawn", "card", "bowl", "bottle"),
                         [](const auto& shape) { return shape.param; });

TEST(Shapes, ListOfKindsIsComplete) {
  std::size_t count = 0;
  for (const ShapeKind& kind : shape_kinds()) {
    EXPECT_NO_THROW((void)make_shape(kind.name)) << kind.name;
    ++count;
  }
  EXPECT_EQ(count, 14u);  // as instantiated above
}

// Volumes by hand: boxes by product; polygons with n corners of circumradius r have area n/2 r² sin(2π/n).
TEST(Shapes, VolumesAreThoseOfTheirPolyhedra) {
  const auto disc = [](double r, int n) { return n / 2.0 * r * r * std::sin(2 * brute::pi / n); };
  const auto volume = [](const Mesh& mesh) { return solid_properties(mesh).volume; };
  const auto expect = [](double actual, double expected) { EXPECT_NEAR(actual / expected, 1, 1e-12); };
  expect(volume(make_l_shape(0.08, 0.06, 0.02, 0.03)), (0.08 * 0.02 + 0.04 * 0.02) * 0.03);
  expect(volume(make_cup(0.04, 0.095, 0.003, 96)), disc(0.04, 96) * 0.095 - disc(0.037, 96) * 0.092);
  expect(volume(make_plate_with_hole({0.1, 0.08, 0.012}, 0.02, 64)), (0.1 * 0.08 - disc(0.02, 64)) * 0.012);
  expect(volume(make_hammer({0.25, 0.014, {0.11, 0.034, 0.034}, 64})), disc(0.014, 64) * 0.25 + 0.11 * 0.034 * 0.034);
  // Head of the axe: a rectangle from the poll to the handle's radius, then a triangle to the edge.
  const double head = (0.04 + 0.015) * 0.034 + (0.12 - 0.015) * 0.034 / 2;
  expect(volume(make_axe()), disc(0.015, 64) * 0.4 + head * 0.08);
  // Torus by Pappus, up to the inscribed polygons: n sin(2π/n)/(2π) each way.
  const double pappus = 2 * brute::pi * 0.04 * brute::pi * 0.012 * 0.012;
  EXPECT_NEAR(volume(make_torus(0.04, 0.012, 64, 32)) / pappus, 1, 0.009);  // 0.64 % + 0.16 %
}

TEST(Shapes, MugHoldsItsHandle) {
  const double cup = solid_properties(make_cup(0.04, 0.095, 0.003, 96)).volume;
  const double mug = solid_properties(make_mug()).volume;
  // Half a ring of the handle's section along its bow, and two stubs; the patches on the round wall blur it by a tenth.
  const double bow = 0.025 - 0.025 / 4 + 0.005, section = brute::pi * 0.005 * 0.005;
  EXPECT_NEAR(mug - cup, section * (brute::pi * bow + 2 * 0.025 / 4), 0.15 * (mug - cup));
}

template <class Make>
std::string message(const Make& make) {
  try {
    (void)make();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Shapes, ErrorsListWhatIsValid) {
  const std::string kind = message([] { return make_shape("teapot"); });
  EXPECT_NE(kind.find("shape 'teapot': no such kind (choose from box, sphere"), std::string::npos) << kind;
  const std::string parameter = message([] { return make_shape("box", {{"radius", 1.0}}); });
  EXPECT_EQ(parameter, "shape box with parameter 'radius': no such parameter (choose from x, y, z)");
  EXPECT_NE(message([] { return make_shape("sphere", {{"subdivisions", 2.5}}); }).find("whole"), std::string::npos);
}

TEST(Shapes, RejectSizesWithoutASolid) {
  const std::map<std::string, std::map<std::string, double>> bad = {
      {"box", {{"x", 0}}},
      {"sphere", {{"radius", -1}}},
      {"cylinder", {{"segments", 2}}},
      {"l_shape", {{"width", 0.07}}},
      {"torus", {{"minor_radius", 0.05}}},
      {"plate_with_hole", {{"hole_radius", 0.05}}},
      {"cup", {{"wall", 0.05}}},
      {"mug", {{"handle_gap", 0.06}}},
      {"hammer", {{"head_y", 0.02}}},
      {"axe", {{"handle_length", NAN}}},
      {"pawn", {{"height", INFINITY}}},
  };
  for (const auto& [kind, parameters] : bad) EXPECT_THROW((void)make_shape(kind, parameters), InputError) << kind;
}

}  // namespace
}  // namespace handhold
