// SPDX-License-Identifier: GPL-3.0-or-later
// Stiction is exact: what sticks does not creep. The closed forms of rigid friction are cases of the catalogue.

#include <cmath>
#include <cstdio>

#include "tests/reference/rigid/problems.hpp"

namespace handhold::reference::rigid::testing {
namespace {

const Options coarse{1e-10, 1e-2, 1};

/// Over a minute, a block under two thirds of its cone does not move by one bit.
TEST(Stiction, DoesNotCreepInAMinute) {
  RigidProblem p = block(0.2, {0.5, 0.4}, 60);
  p.gravity = tilted_gravity(0.3);
  const Trajectory t = run(p, coarse);
  EXPECT_TRUE(t.events.empty());
  for (const Frame& f : t.frames) {
    EXPECT_EQ(f.body.X_WO.p.x(), 0);
    EXPECT_EQ(f.body.X_WO.p.y(), 0);
    EXPECT_EQ(f.supports[0].mode, Mode::stick);
  }
}

/// Where axes are odd, round-off of the accelerations remains: 1e-16 g, which the equations' own recovery keeps from
/// adding up (velocity error 1e-15/α = 1e-17 m/s, a minute of it 1e-15 m).
TEST(Stiction, KeepsRoundOffAtRoundOffOnAnOddPlane) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, z_axis) * Eigen::AngleAxisd(0.3, y_axis));
  RigidProblem p = block(0.2, {0.5, 0.4}, 60);
  p.supports[0].surface = make_plane({0, 0, 0}, turn * z_axis);
  const Trajectory t = run(p, coarse);
  std::printf("[  figure  ] creep on an odd plane in 60 s: %.1e m\n", t.frames.back().body.X_WO.p.norm());
  EXPECT_LE(t.frames.back().body.X_WO.p.norm(), 1e-14);
  EXPECT_EQ(t.frames.back().supports[0].mode, Mode::stick);
}

TEST(Stiction, StopsForGood) {
  RigidProblem p = block(0.2, {0.5, 0.4}, 20);
  p.gravity = tilted_gravity(0.4);
  p.V_WB.v = -x_axis;
  const Trajectory t = run(p, coarse);
  ASSERT_EQ(t.events.size(), 1u);
  EXPECT_EQ(t.frames.back().body.X_WO.p.x(), t.events[0].after.X_WO.p.x());
}

TEST(Stiction, OfAPinchDoesNotCreepInAMinute) {
  const Trajectory t = run(grip(2, 0.2, {0.5, 0.4}, constant(2.5), {}, 60), coarse);
  EXPECT_EQ(t.frames.back().supports[0].mode, Mode::stick);
  std::printf("[  figure  ] creep of a pinch in 60 s: %.1e m\n", t.frames.back().body.X_WO.p.norm());
  EXPECT_LE(t.frames.back().body.X_WO.p.norm(), 1e-14);  // round-off, kept from adding up
}

/// On a palm that turns there and back, a block keeps its place on the palm: what the carried acceleration (α, w², and
/// no Coriolis part at rest) asks of friction is given exactly, up to the integrator's accuracy.
TEST(Stiction, HoldsOnAPalmThatRocks) {
  RigidProblem p = block(0.2, {0.9, 0.8}, 2);
  p.X_WB.p = 0.1 * x_axis;
  const double swing = 0.4, w = 5;
  p.supports[0].turn = [=](double t) {
    return TurnPoint{Eigen::Quaterniond(Eigen::AngleAxisd(swing * std::sin(w * t), y_axis)),
                     swing * w * std::cos(w * t) * y_axis, -swing * w * w * std::sin(w * t) * y_axis};
  };
  p.V_WB.v = (swing * w * y_axis).cross(p.X_WB.p);
  const Trajectory t = run(p, {1e-10, 1e-3, 90});
  EXPECT_TRUE(t.events.empty());
  for (const Frame& f : t.frames) {
    const Eigen::Vector3d on_palm = p.supports[0].turn(f.t).R.conjugate() * f.body.X_WO.p;
    EXPECT_NEAR((on_palm - p.X_WB.p).norm(), 0, 1e-9) << f.t;
  }
}

}  // namespace
}  // namespace handhold::reference::rigid::testing
