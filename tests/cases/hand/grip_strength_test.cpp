// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/grip_strength.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/phalanx_depth.hpp"
#include "cases/model/patch.hpp"

namespace handhold {
namespace {

constexpr double K = 800, mu = 0.5, depth = 0.004, ring = 0.003, weight = 1.3;

std::vector<GripPad> pinch() {
  return {{{0.02, 0, 0}, {1, 0, 0}, depth, ring}, {{-0.02, 0, 0}, {-1, 0, 0}, depth, ring}};
}

GripLoad load(const Eigen::Vector3d& center) { return {{0, 0, -weight}, center, K, mu}; }

// Each of two opposite pads presses with K d and carries half of the weight by friction.
TEST(GripMargin, OfAPinchThroughTheCentreIsCoulombs) {
  EXPECT_NEAR(grip_margin(pinch(), load({0, 0, 0})), 2 * mu * K * depth / weight, 1e-12);
}

// A centre of mass `a` aside of the line twists both pads about it: each ring of torsional stiffness K r² takes W a /
// 2, a force W a / (2 r) around it.
TEST(GripMargin, FallsWithTheLeverOfTheWeight) {
  const double a = 0.01;
  const double expected = 2 * mu * K * depth / (weight * std::hypot(1, a / ring));
  EXPECT_NEAR(grip_margin(pinch(), load({0, a, 0})), expected, 1e-12);
}

TEST(GripMargin, NothingThatPressesCarriesNothing) { EXPECT_EQ(grip_margin({}, load({0, 0, 0})), 0); }

// One pad alone is pushed off: the object moves away from it until it presses no more.
TEST(GripMargin, OfOnePadIsNone) {
  const std::vector<GripPad> one = {pinch().front()};
  EXPECT_NEAR(grip_margin(one, load({0.02, 0, 0})), 0, 1e-9);
}

// The quick look is the exact search to the diagonal of a voxel, where the surface is flat and inside the band.
TEST(PhalanxDepth, IsThatOfTheExactSearch) {
  const auto field = voxelize(make_box({0.06, 0.06, 0.06}), {0.001, 0.012});
  const PhalanxShape finger = Capsule{0.01, 0.008};
  for (const double x : {0.028, 0.032, 0.036, 0.037}) {
    const Pose X_OP{Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY())), {x, 0.004, 0.002}};
    const PhalanxDepth quick = phalanx_depth(finger, X_OP, *field);
    EXPECT_NEAR(quick.depth, -nearest(finger, X_OP, *field).distance, 0.001 * std::sqrt(3)) << x;
    EXPECT_NEAR(quick.n_O.x(), 1, 1e-6) << x;
  }
}

}  // namespace
}  // namespace handhold
