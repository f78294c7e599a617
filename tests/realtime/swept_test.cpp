// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/realtime/scenes.hpp"

// Fast hands and gaps in the tracking: nothing is jumped over.

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;
using namespace testing;  // NOLINT: this file's scenes

constexpr double thickness = 0.002;

/// A fixed wall in the plane x z, and a fingertip that comes from 95 mm before it at 5 m/s and stops 60 mm behind.
Scene wall_scene() {
  Scene scene;
  scene.name = "wall";
  scene.bodies = {catalogue::block({0.1, thickness, 0.1}, 0.0005, 0.1, {})};
  scene.bodies[0].mobility = Mobility::fixed;
  const auto path = [](double t) -> Vector3d { return {0, std::clamp(5 * t, 0.0, 0.155), 0}; };
  scene.hands = {finger(path, {0.001, -0.095, 0.002}, 0.5)};
  return scene;
}

struct Touching {
  int count{};
  double depth{};
  Vector3d n{Vector3d::Zero()};
};

Touching touching(const World& world) {
  Touching t;
  for (std::size_t i = 0; i < world.contacts().size(); ++i) {
    const ContactState c = world.contact(i);
    if (c.mode == Mode::apart) continue;
    ++t.count;
    t.depth = std::max(t.depth, c.depth);
    t.n = c.n_W;
  }
  return t;
}

TEST(Swept, AFastFingerIsCaughtByAThinWall) {
  const Scene scene = wall_scene();
  for (const double rate : {45.0, 90.0, 1000.0})
    for (const int substeps : {1, 4}) {
      World world = started(scene, {.substeps = substeps}, 1 / rate);
      run(world, scene, int(0.1 * rate), 1 / rate);
      const Touching t = touching(world);
      EXPECT_EQ(t.count, 8) << rate;
      EXPECT_LT(t.n.y(), -0.999) << rate;  // the sheet touched first
      // 60 mm behind the middle of the wall, its skin (radius 8 mm or so) still farther.
      EXPECT_NEAR(t.depth, 0.06 + thickness / 2 + 0.008, 0.003) << rate;
    }
}

TEST(Swept, ShortGapIsBridgedStraight) {
  const Scene scene = wall_scene();
  const double dt = 1.0 / 90;
  for (const double bridge : {0.1, 0.0}) {
    World world = started(scene, {.substeps = 2, .longest_bridge = bridge}, dt);
    for (int k = 1; k <= 9; ++k)
      world.advance(dt, k < 4 ? std::vector<HandFrame>(1) : frames(scene, k * dt));  // lost from the first frame on
    const Touching t = touching(world);
    EXPECT_EQ(t.count, bridge > 0 ? 8 : 0);
    if (bridge > 0) {
      EXPECT_LT(t.n.y(), -0.999);
    }
  }
}

TEST(Swept, AHandThatAppearsDeepInsideIsPushedToTheNearestFace) {
  Scene scene;
  scene.name = "deep";
  scene.bodies = {catalogue::block({0.2, 0.2, 0.2}, 0.002, 1, {})};
  scene.bodies[0].mobility = Mobility::fixed;
  const auto rest = [](double) -> Vector3d { return Vector3d::Zero(); };
  scene.hands = {finger(rest, {0.01, 0.015, 0.05}, 0.5)};
  const double dt = 1.0 / 90;
  World world(world_def_of(scene), {.substeps = 1});
  world.start(dt, std::vector<HandFrame>(1));
  for (int k = 1; k <= 3; ++k) world.advance(dt, frames(scene, k * dt));
  const Touching t = touching(world);
  EXPECT_EQ(t.count, 8);
  EXPECT_GT(t.n.z(), 0.999);  // 50 mm to this face, 85 to the next
  EXPECT_GT(t.depth, 0.05);   // of the skin that is deepest
  EXPECT_LT(t.depth, 0.05 + 0.03);
}

}  // namespace
}  // namespace handhold::realtime
