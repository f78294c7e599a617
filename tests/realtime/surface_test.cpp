// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/detection/surface.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;

const auto box = voxelize(make_box({0.06, 0.04, 0.02}), {.voxel_size = 0.001});
const auto wall = voxelize(make_box({0.06, 0.06, 0.002}), {.voxel_size = 0.0005});
const auto ball = voxelize(make_sphere(0.03, 5), {.voxel_size = 0.001});

/// Definition: six more queries. A central difference of the interpolant is the interpolant of central differences, so
/// only rounding of floats' sums may differ: 1e-16 of a distance of 4 mm over 2 mm.
TEST(SmoothDistance, IsTheCentralDifferenceOfTheInterpolatedDistance) {
  const double h = ball->grid().spacing;
  for (const Vector3d& p : {Vector3d(0.029, 0.003, 0.004), Vector3d(-0.01, 0.02, -0.0213), Vector3d(0, 0, 0.0301)}) {
    const SmoothDistance s = smooth_distance(*ball, p);
    EXPECT_NEAR(s.distance, ball->distance(p).distance, 1e-15);
    for (int i = 0; i < 3; ++i) {
      const Vector3d step = h * Vector3d::Unit(i);
      const double slope = (ball->distance(p + step).distance - ball->distance(p - step).distance) / (2 * h);
      EXPECT_NEAR(s.gradient[i], slope, 1e-12) << i;
    }
  }
}

TEST(SmoothDistance, WorksOffTheGrid) {
  const SmoothDistance s = smooth_distance(*box, {1, 0, 0});
  EXPECT_GT(s.distance, 0.9);
  EXPECT_NEAR(s.gradient.x(), 1, 1e-9);
}

TEST(Foot, LiesBelowAPointOutsideAFace) {
  Anchor anchor;
  ASSERT_TRUE(foot(*box, {0.01, 0.005, 0.012}, anchor));
  // Distances are floats: 4 mm with 24 bits is 2e-10.
  EXPECT_LT((anchor.C_O - Vector3d(0.01, 0.005, 0.01)).norm(), 1e-9);
  EXPECT_LT((anchor.n_O - Vector3d::UnitZ()).norm(), 1e-6);
}

TEST(Foot, IsTheExactNearestPointHoweverDeepInside) {
  Anchor anchor;  // 10 mm deep, the band ends at 12
  ASSERT_TRUE(foot(*ball, {0, 0.002, 0}, anchor));
  EXPECT_NEAR(anchor.C_O.norm(), 0.03, 1e-4);  // facets of 1.5 mm: sagitta 1e-5; voxels' second order
  const auto big = voxelize(make_box({0.2, 0.2, 0.2}), {.voxel_size = 0.002, .band = 0.008});
  ASSERT_TRUE(foot(*big, {0.02, -0.04, 0.01}, anchor));  // 60 mm deep: seven bands
  EXPECT_LT((anchor.C_O - Vector3d(0.02, -0.1, 0.01)).norm(), 1e-9);
  EXPECT_LT((anchor.n_O + Vector3d::UnitY()).norm(), 1e-6);
}

TEST(Foot, LeavesTheAnchorAloneWhereThereIsNone) {
  Anchor anchor{{1, 2, 3}, {4, 5, 6}};
  EXPECT_FALSE(foot(*box, {0.5, 0, 0}, anchor));
  EXPECT_EQ(anchor.C_O, Vector3d(1, 2, 3));
}

TEST(FindTouch, TakesTheFirstSheetOfAThinWall) {
  for (const TouchNormal normal : {TouchNormal::smooth, TouchNormal::face}) {
    Anchor anchor;
    ASSERT_TRUE(find_touch(*wall, {0.001, 0.002, 0.04}, {0.001, 0.002, -0.05}, normal, anchor));
    EXPECT_LT((anchor.C_O - Vector3d(0.001, 0.002, 0.001)).norm(), 1e-9);  // floats, as above
    EXPECT_LT((anchor.n_O - Vector3d::UnitZ()).norm(), 1e-6);
  }
}

TEST(FindTouch, IsTheNearestPointForOneThatWasInside) {
  Anchor anchor;
  ASSERT_TRUE(find_touch(*box, {0, 0, 0.008}, {0, 0, 0.0081}, TouchNormal::face, anchor));
  EXPECT_LT((anchor.C_O - Vector3d(0, 0, 0.01)).norm(), 1e-15);
}

TEST(FindTouch, FindsNothingOnTheWayOutOrPast) {
  Anchor anchor;
  EXPECT_FALSE(find_touch(*box, {0, 0, 0.008}, {0, 0, 0.02}, TouchNormal::face, anchor));
  EXPECT_FALSE(find_touch(*box, {-0.1, 0, 0.011}, {0.1, 0, 0.011}, TouchNormal::face, anchor));
  EXPECT_FALSE(find_touch(*box, {0, 0, 0.02}, {0, 0, std::nan("")}, TouchNormal::face, anchor));
}

/// An arc of 0.5 rad on a ball: C stays on it, n stays radial.
TEST(Slide, FollowsACurvedSurface) {
  Anchor anchor;
  ASSERT_TRUE(foot(*ball, {0, 0, 0.0305}, anchor));
  for (int i = 0; i < 50; ++i) {
    const Vector3d along = Vector3d::UnitY().cross(anchor.n_O);
    EXPECT_TRUE(slide(*ball, 0.8 * anchor.C_O, 0.0003 * along, anchor));
  }
  EXPECT_NEAR(std::atan2(anchor.C_O.x(), anchor.C_O.z()), 0.5, 0.005);
  EXPECT_NEAR(anchor.C_O.norm(), 0.03, 5e-5);                   // facets and voxels' second order h²/R = 3e-5
  EXPECT_LT(anchor.n_O.cross(anchor.C_O).norm() / 0.03, 0.02);  // 1 degree
}

/// Over an edge, 2 mm before its end, with a sample deep inside: down the side face, never off the surface nor through
/// the box.
TEST(Slide, TurnsOverAnEdge) {
  Anchor anchor;
  ASSERT_TRUE(foot(*box, {0.028, 0, 0.0105}, anchor));
  for (int i = 0; i < 10; ++i)
    EXPECT_TRUE(slide(*box, {0.02, 0, -0.009}, 0.001 * Vector3d::UnitY().cross(anchor.n_O), anchor));
  EXPECT_LT(std::abs(box->distance(anchor.C_O).distance), 1e-4);  // a tenth of a voxel
  EXPECT_LT(anchor.C_O.z(), 0.01);
  EXPECT_GT(anchor.n_O.x(), 0.9);
}

/// The sample has passed the edge: straight on, to the last bit but rounding, and off.
TEST(Slide, LeavesASampleThatSlidOffAnEdge) {
  Anchor anchor{{0.028, 0, 0.01}, Vector3d::UnitZ()};
  EXPECT_FALSE(slide(*box, {0.05, 0, 0.005}, {0.02, 0, 0}, anchor));
  EXPECT_LT((anchor.C_O - Vector3d(0.048, 0, 0.01)).norm(), 1e-15);
  EXPECT_EQ(anchor.n_O, Vector3d::UnitZ());
}

/// Over the floor of a mug into its wall (inner radius 34 mm), 17 mm in one step, with a sample inside the wall; and
/// with one beyond it.
TEST(Slide, IsCaughtInAHollowEdge) {
  const auto mug =
      voxelize(make_mug({.radius = 0.04, .height = 0.08, .wall = 0.006, .segments = 48}), {.voxel_size = 0.001});
  Anchor floor;
  ASSERT_TRUE(find_touch(*mug, {0, 0.02, 0}, {0, 0.02, -0.039}, TouchNormal::smooth, floor));
  ASSERT_GT(floor.n_O.z(), 0.999);
  Anchor anchor = floor;
  const Vector3d inside = floor.C_O + Vector3d(0, 0.017, -0.001);
  EXPECT_TRUE(slide(*mug, inside, {0, 0.017, 0}, anchor));
  EXPECT_LT(std::abs(mug->distance(anchor.C_O).distance), 1e-4);  // a tenth of a voxel
  EXPECT_NEAR(anchor.C_O.y(), 0.034, 0.001);                      // a voxel
  anchor = floor;
  EXPECT_FALSE(slide(*mug, floor.C_O + Vector3d(0, 0.024, -0.001), {0, 0.023, 0}, anchor));  // 4 mm outside the mug
  EXPECT_LT((anchor.C_O - floor.C_O - Vector3d(0, 0.023, 0)).norm(), 1e-15);
}

/// An anchor right on the edge between a mug and its handle (random grasp 77696), which smooth distances round off by a
/// third of a voxel: it was taken back to the rounded edge, against its way.
TEST(Slide, NeverEndsBehindWhereItBegan) {
  const auto mug =
      voxelize(make_mug({.radius = 0.04, .height = 0.08, .wall = 0.006, .segments = 48}), {.voxel_size = 0.002});
  const double projection_error = 0.1 * mug->grid().spacing;
  const Vector3d way = Vector3d(-0.9158, 0.4016, 0).normalized();
  for (const double length : {1e-6, 1e-5, 1e-4, 5e-4, 1e-3}) {
    Anchor anchor{{0.036661, -0.003886, -0.022991}, -Vector3d::UnitZ()};
    const Anchor before = anchor;
    EXPECT_TRUE(slide(*mug, {0.035606, -0.003409, -0.021804}, length * way, anchor));
    EXPECT_GE((anchor.C_O - before.C_O).dot(way), -projection_error) << length;
  }
}

TEST(Slide, IgnoresAStepThatIsNotFinite) {
  Anchor anchor{{0, 0, 0.01}, {0, 0, 1}};
  EXPECT_TRUE(slide(*box, {0, 0, 0}, {std::nan(""), 0, 0}, anchor));
  EXPECT_EQ(anchor.C_O, Vector3d(0, 0, 0.01));
}

}  // namespace
}  // namespace handhold::realtime
