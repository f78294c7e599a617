// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/detection/proximity.hpp"

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;

const auto wall = voxelize(make_box({0.1, 0.1, 0.002}), {.voxel_size = 0.0005});
const Capsule capsule{0.01, 0.008};
constexpr double offset = 0.002;

Pose at(double z) { return {Eigen::Quaterniond(Eigen::AngleAxisd(1.5707963, Vector3d::UnitX())), {0, 0, z}}; }

TEST(Proximity, DoesNotJumpOverAThinWall) {
  Proximity proximity{capsule};
  const std::optional<Pose> found = proximity.approach(*wall, at(0.15), at(-0.15), offset);
  ASSERT_TRUE(found);
  EXPECT_GT(found->p.z(), 0.009);  // before it is inside: surface 1 mm + radius 8 mm
  EXPECT_LT(found->p.z(), 0.011 + 1e-6);
  EXPECT_LT(proximity.place().distance, offset);
  EXPECT_GT(proximity.place().n_O.z(), 0.999);
}

TEST(Proximity, SeesAFingerThatTurnsIn) {
  Proximity proximity{Capsule{0.04, 0.005}};  // 45 mm from its centre to its tip, which stands 30 mm off the wall
  const Pose upright{Eigen::Quaterniond::Identity(), {0, 0, 0.03}};
  const Pose level{Eigen::Quaterniond(Eigen::AngleAxisd(1.5707963, Vector3d::UnitX())), {0, 0, 0.03}};
  const std::optional<Pose> found = proximity.approach(*wall, level, upright, offset);
  ASSERT_TRUE(found);
  EXPECT_LT(proximity.place().distance, offset);
  EXPECT_GT(proximity.place().distance, 0);
}

TEST(Proximity, StartsInsideWhereItIs) {
  Proximity proximity{capsule};
  const std::optional<Pose> found = proximity.approach(*wall, at(0.005), at(0.005), offset);
  ASSERT_TRUE(found);
  EXPECT_NEAR(proximity.place().distance, 0.004 - 0.008, 1e-9);
}

TEST(Proximity, StaysAway) {
  Proximity proximity{capsule};
  EXPECT_FALSE(proximity.approach(*wall, at(0.1), at(0.0115), offset));  // 2.5 mm off at the end
  EXPECT_FALSE(proximity.approach(*wall, at(0.0115), at(0.1), offset));
  EXPECT_FALSE(proximity.approach(*wall, {at(0).R, {0.2, 0, 0.1}}, {at(0).R, {0.2, 0, -0.1}}, offset));  // past it
  EXPECT_TRUE(proximity.leaves(*wall, at(0.0135), 0.004));                                               // 4.5 mm
  EXPECT_FALSE(proximity.leaves(*wall, at(0.0125), 0.004));
}

}  // namespace
}  // namespace handhold::realtime
