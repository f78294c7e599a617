// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/detection/surface.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/edge_scenes.hpp"
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

/// Without friction, to below a pull that is `depth` below the end of the step.
Slip dragged(const Anchor& anchor, const Vector3d& step, double depth) {
  return {.pull_O = anchor.C_O + step - depth * anchor.n_O, .step_O = step};
}

/// An arc of 0.5 rad on a ball: C stays on it, n stays radial.
TEST(Slide, FollowsACurvedSurface) {
  Anchor anchor;
  ASSERT_TRUE(foot(*ball, {0, 0, 0.0305}, anchor));
  for (int i = 0; i < 50; ++i) {
    const Vector3d along = Vector3d::UnitY().cross(anchor.n_O);
    EXPECT_TRUE(slide(*ball, dragged(anchor, 0.0003 * along, 0.006), anchor));
  }
  EXPECT_NEAR(std::atan2(anchor.C_O.x(), anchor.C_O.z()), 0.5, 0.005);
  EXPECT_NEAR(anchor.C_O.norm(), 0.03, 5e-5);                   // facets and voxels' second order h²/R = 3e-5
  EXPECT_LT(anchor.n_O.cross(anchor.C_O).norm() / 0.03, 0.02);  // 1 degree
}

/// On a plane, with friction: the step as planned, to rounding, across a diagonal of the face and within a face.
TEST(Slide, TakesTheStepThatIsPlannedOnAPlane) {
  for (const Vector3d& step : {Vector3d(0.001, 0.0005, 0), Vector3d(0.02, -0.003, 0), Vector3d(-0.005, 0.03, 0)}) {
    Anchor anchor;
    ASSERT_TRUE(find_touch(*box, {0.005, -0.014, 0.02}, {0.005, -0.014, 0.005}, TouchNormal::smooth, anchor));
    const Vector3d start = anchor.C_O, ahead = step.normalized();
    Slip slip = dragged(anchor, step, 0.005);
    slip.pull_O += 0.4 * 0.005 * ahead;
    slip.mu = 0.4;
    EXPECT_TRUE(slide(*box, slip, anchor));
    EXPECT_LT((anchor.C_O - start - step).norm(), 1e-9);  // floats of the smooth part
    EXPECT_LT((anchor.n_O - Vector3d::UnitZ()).norm(), 1e-6);
    EXPECT_FALSE(anchor.hollow);
  }
}

/// Over an edge that turns down by 60 degrees, to where the second face is nearest to a pull below both.
TEST(Slide, GoesOverAConvexEdge) {
  const double turn = M_PI / 3;
  const auto edge = voxelize(catalogue::convex_edge(turn), {.voxel_size = 0.002});
  Anchor anchor{{-0.0005, 0.001, 0}, Vector3d::UnitZ()};
  const Vector3d pull(0.0005, 0.001, -0.002), down(std::cos(turn), 0, -std::sin(turn));
  EXPECT_TRUE(follow(*edge, pull, anchor));
  EXPECT_LT((anchor.C_O - pull.dot(down) * down - 0.001 * Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT((anchor.n_O - Vector3d(std::sin(turn), 0, std::cos(turn))).norm(), 1e-12);
}

/// The pull has passed the edge: there the anchor stays.
TEST(Slide, EndsAtAnEdgeBeyondWhichNothingPresses) {
  Anchor anchor{{0.028, 0.001, 0.01}, Vector3d::UnitZ()};
  EXPECT_FALSE(slide(*box, dragged(anchor, {0.02, 0, 0}, 0.005), anchor));
  EXPECT_LT((anchor.C_O - Vector3d(0.03, 0.001, 0.01)).norm(), 1e-12);
}

/// Over the floor of a cup into its wall (inner radius 37 mm), with a sample inside the wall; and with one beyond it,
/// outside the cup: an anchor does not jump to another sheet.
TEST(Slide, IsCaughtInAHollowEdge) {
  constexpr int segments = 96;
  const auto cup = voxelize(make_cup(0.04, 0.08, 0.003, segments), {.voxel_size = 0.001});
  Anchor floor;
  ASSERT_TRUE(find_touch(*cup, {0.001, 0.02, 0}, {0.001, 0.02, -0.0395}, TouchNormal::smooth, floor));
  ASSERT_GT(floor.n_O.z(), 0.999);
  for (const double way : {0.018, 0.024}) {
    Anchor anchor = floor;
    EXPECT_TRUE(slide(*cup, dragged(floor, {0, way, 0}, 0.0005), anchor));
    const double sagitta = 0.037 * (1 - std::cos(M_PI / segments));
    EXPECT_NEAR(anchor.C_O.head<2>().norm(), 0.037 - sagitta / 2, sagitta / 2 + 1e-9);
    EXPECT_NEAR(anchor.C_O.z(), floor.C_O.z(), 1e-9);
    EXPECT_TRUE(anchor.hollow);
    EXPECT_LT(anchor.n_O.y(), -0.8);  // against the wall, which it is deeper in than in the floor
  }
}

/// An anchor at the edge between a mug and its handle (random grasp 77696): smooth distances, which round that off by a
/// third of a voxel, once took it back against its way.
TEST(Slide, NeverEndsBehindWhereItBegan) {
  const auto mug =
      voxelize(make_mug({.radius = 0.04, .height = 0.08, .wall = 0.006, .segments = 48}), {.voxel_size = 0.002});
  Anchor before;
  ASSERT_TRUE(foot(*mug, {0.036661, -0.003886, -0.022991}, before));
  const Vector3d pull(0.035606, -0.003409, -0.021804), depth = (pull - before.C_O).dot(before.n_O) * before.n_O;
  const Vector3d way = (pull - before.C_O - depth).normalized();
  for (const double length : {1e-6, 1e-5, 1e-4, 5e-4, 1e-3}) {
    Anchor anchor = before;
    (void)slide(*mug, {.pull_O = pull, .step_O = length * way, .mu = 0.4}, anchor);
    EXPECT_GE((anchor.C_O - before.C_O).dot(way), -1e-12) << length;
  }
}

TEST(Slide, IgnoresAStepThatIsNotFinite) {
  Anchor anchor{{0, 0, 0.01}, {0, 0, 1}};
  EXPECT_TRUE(slide(*box, {.step_O = {std::nan(""), 0, 0}}, anchor));
  EXPECT_EQ(anchor.C_O, Vector3d(0, 0, 0.01));
}

}  // namespace
}  // namespace handhold::realtime
