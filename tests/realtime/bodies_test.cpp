// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "tests/realtime/scenes.hpp"

// Bodies that touch each other.

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;
using namespace testing;  // NOLINT: this file's scenes

/// A block of 0.5 kg on the ground, at the depth at which its four corners carry it, under gravity that is tilted by
/// `slope` (so that it is the ground that slopes), moving at `v`.
Scene slope_scene(double slope, const Vector3d& v, double direction = 0) {
  Scene scene;
  scene.name = "slope";
  scene.gravity = 9.81 * Vector3d(std::sin(slope), 0, -std::cos(slope));
  Body block = touching_block({0.1, 0.1, 0.04}, 0.5, 0.1);
  block.X_WO.R = Eigen::AngleAxisd(direction, Vector3d::UnitZ());
  block.X_WO.p = {-0.2, 0, 0.02 - 0.5 * 9.81 * std::cos(slope) / (4 * scene.body_contact.stiffness)};
  block.V_WO.v = v;
  scene.bodies = {ground({0.8, 0.6, 0.05}), block};
  return scene;
}

TEST(Bodies, ABlockStaysOnAnInclineWithoutCreep) {
  // Held back at first and let go slowly: springs that take up the weight at once would overshoot a margin of 1 %.
  Scene scene = slope_scene(std::atan(0.5 / 1.01), Vector3d::Zero());
  const double along = 0.5 * scene.gravity.x();
  scene.bodies[1].load = [=](double t) { return Load{{-along * std::exp(-std::pow(t / 0.3, 2)), 0, 0}, {0, 0, 0}}; };
  for (const double rate : {60.0, 90.0, 120.0, 1000.0})
    for (const int order : {1, 2}) {
      World world = started(scene, {.substeps = 1, .order = order}, 1 / rate);
      run(world, scene, 3 * int(rate), 1 / rate);
      const Vector3d settled = world.bodies()[1].X_WO.p;
      run(world, scene, 60 * int(rate), 1 / rate);
      // The element sticks exactly; what may move is rounding: 1e-9 mm/s over 60 s is the bound asked for.
      EXPECT_LT((world.bodies()[1].X_WO.p - settled).norm(), 60 * 1e-12) << rate << " " << order;
      EXPECT_LT(settled.x(), -0.2 + 1e-4);  // m g sin / (4 k) = 3e-5 of lag
    }
}

/// Tipped by a short torque, the block falls back. With one edge lifted by z its centre is z/2 higher: two corners that
/// catch all of that go m g z / 2 = ½ (2 k) d² deep, and m g / (2 k) as they carry it.
TEST(Bodies, ABlockThatWasTippedLandsOnTheGroundAgain) {
  for (const double spacing : {0.1, 0.05, 0.02})
    for (const int order : {1, 2}) {
      Scene scene = slope_scene(0, Vector3d::Zero());
      scene.bodies[1].samples_O = surface_samples(make_box({0.1, 0.1, 0.04}), spacing);
      scene.bodies[1].load = [](double t) { return t > 0.2 && t < 0.22 ? Load{{0, 0, 0}, {0, 0.4, 0}} : Load{}; };
      World world = started(scene, {.substeps = 4, .order = order}, 1.0 / 90);
      double lowest = 0, highest = 0;
      for (int k = 1; k <= 90; ++k) {
        world.advance(1.0 / 90, {});
        for (const double x : {-0.05, 0.05})
          for (const double y : {-0.05, 0.05}) {
            const double z = (world.bodies()[1].X_WO * Vector3d(x, y, -0.02)).z();
            lowest = std::min(lowest, z);
            highest = std::max(highest, z);
          }
      }
      const double twice_k = 2 * scene.body_contact.stiffness, weight = 0.5 * 9.81;
      EXPECT_GT(highest, 1e-3) << spacing << " " << order;
      EXPECT_LT(highest, 5e-3) << spacing << " " << order;
      EXPECT_GT(lowest, -weight / twice_k - std::sqrt(weight * highest / twice_k)) << spacing << " " << order;
    }
}

/// x = g (sin − μ cos) t²/2. The springs' own transient is as long as the lag at the start, μ N / k = 3e-5 m. The step
/// in which the block touches and the next one are implicit Euler: a h²/2 each.
TEST(Bodies, ABlockSlidesDownAnIncline) {
  const double slope = M_PI / 6, t = 0.3;
  const Scene scene = slope_scene(slope, Vector3d::Zero());
  World world = started(scene, {.substeps = 1, .order = 2}, 1.0 / 90);
  run(world, scene, 27, 1.0 / 90);
  const double a = 9.81 * (std::sin(slope) - 0.5 * std::cos(slope));
  EXPECT_NEAR(world.bodies()[1].X_WO.p.x() + 0.2, a * t * t / 2 + a / (90 * 90), 4e-5);
}

/// v² / (2 μ g), whatever the direction: the first order's bias at 90 Hz is a v h / 2, 2 % here. The steps in which the
/// block touches and stops, and the one after each, are implicit Euler: μ g h² / 2 each.
TEST(Bodies, StopsWhereCoulombSays) {
  const double speed = 1.5, truth = speed * speed / (2 * 0.5 * 9.81);
  for (const double angle : {0.0, M_PI / 6, M_PI / 4}) {
    const Vector3d along(std::cos(angle), std::sin(angle), 0);
    const Scene scene = slope_scene(0, speed * along);
    World world = started(scene, {.substeps = 2, .order = 2}, 1.0 / 90);
    run(world, scene, 60, 1.0 / 90);
    const Vector3d way = world.bodies()[1].X_WO.p - scene.bodies[1].X_WO.p;
    EXPECT_NEAR(way.dot(along) / truth, 1, 1e-3) << angle;
    EXPECT_LT((way - way.dot(along) * along).head<2>().norm(), 1e-6) << angle;  // isotropic: rounding, grown by slip
    // It rings on in the springs that stopped it: lag μ m g / (4 k) = 3e-5 m at sqrt(4 k / m) = 400 /s.
    EXPECT_LT(world.bodies()[1].v.norm(), 3e-5 * 400) << angle;
    EXPECT_EQ(world.unconverged(), 0);
  }
}

/// As many equal pieces as keep each turn within 0.25 rad, 16 at most; what flies alone turns exactly and is left
/// alone.
TEST(Bodies, AStepInWhichSomethingThatTouchesTurnsFarIsCut) {
  constexpr double h = 1.0 / 90;
  for (const double w : {10.0, 40.0, 60.0, 2000.0})
    for (const bool touching : {true, false}) {
      Scene scene = slope_scene(0, Vector3d::Zero());
      scene.bodies[1].V_WO.w = {0, 0, w};
      if (!touching) scene.bodies[1].X_WO.p.z() = 5;  // its corners go 1.6 m in a step
      World world = started(scene, {.substeps = 1}, h);
      world.advance(h, {});
      const double turn = h * world.bodies()[1].w.norm();
      world.advance(h, {});
      const std::size_t pieces = touching ? std::min(std::size_t(std::ceil(turn / 0.25)), std::size_t(16)) : 1;
      ASSERT_EQ(world.steps().size(), pieces) << w;
      for (std::size_t i = 0; i < pieces; ++i) {
        EXPECT_DOUBLE_EQ(world.steps()[i].fraction, double(i + 1) / double(pieces));
        EXPECT_DOUBLE_EQ(world.steps()[i].h, h / double(pieces));
      }
    }
}

TEST(Bodies, ATowerStands) {
  Scene scene = blocks(18, 3);
  World world = started(scene, {.substeps = 1}, 1.0 / 90);
  run(world, scene, 900, 1.0 / 90);
  // 0.92 kg on the springs of the lowest layers: well below a tenth of a millimetre of sag, and no drift.
  for (std::size_t i = 1; i < scene.bodies.size(); ++i)
    EXPECT_LT((world.bodies()[i].X_WO.p - scene.bodies[i].X_WO.p).norm(), 2e-4) << i;
  EXPECT_EQ(world.unconverged(), 0);
}

/// Two cubes meet off centre, with spin, without gravity: forces on both are opposite and in one line.
TEST(Bodies, ACollisionKeepsMomentum) {
  Scene scene;
  scene.name = "collision";
  scene.gravity.setZero();
  const Body cube = touching_block({0.04, 0.04, 0.04}, 0.1, 0.02);
  scene.bodies = {cube, cube};
  scene.bodies[0].X_WO.p = {-0.04, 0, 0};
  scene.bodies[0].V_WO = {{1, 2, 0.5}, {0.8, 0, 0}};
  scene.bodies[1].X_WO.p = {0.01, 0.012, 0.007};
  scene.bodies[1].inertia.mass = 0.3;
  const auto momentum = [](const World& world) {
    Vector6 sum = Vector6::Zero();
    for (const RigidBody& b : world.bodies()) {
      const Vector3d p = b.mass * b.v;
      sum.head<3>() += p;
      sum.tail<3>() += b.inertia() * b.w + b.center().cross(p);
    }
    return sum;
  };
  for (const int order : {1, 2}) {
    World world = started(scene, {.substeps = 4, .order = order}, 1.0 / 90);
    const Vector6 before = momentum(world);
    int touches = 0;
    for (int k = 1; k <= 30; ++k) {
      world.advance(1.0 / 90, {});
      touches += int(world.events().size());
      const Vector6 change = momentum(world) - before;
      EXPECT_LT(change.head<3>().norm(), 1e-14) << k;  // rounding of 0.08 N s over 120 steps
      // Forces on both act at one point, in one line. At order 2 they do so at predicted centres, which the impulse (up
      // to 0.08 N s) moves by h² of it.
      EXPECT_LT(change.tail<3>().norm(), order == 1 ? 1e-15 : 0.8 / 360 * 0.08) << k;
    }
    EXPECT_GT(touches, 0);
    EXPECT_GT(world.bodies()[1].v.x(), 0.1);
  }
}

/// A free asymmetric body: its angular momentum and its energy stay to rounding at both orders. Without `keep_energy`
/// it gains at order 1 in every step.
TEST(Bodies, AFreeBodyKeepsItsAngularMomentumAndItsEnergy) {
  Scene scene;
  scene.name = "tumbling";
  scene.gravity.setZero();
  scene.bodies = {catalogue::block({0.06, 0.04, 0.02}, 0.001, 0.2, {})};
  scene.bodies[0].V_WO.w = {0.3, 12, 0.2};  // about the middle axis: it turns over
  for (const int order : {1, 2}) {
    World world = started(scene, {.substeps = 1, .order = order}, 1.0 / 90);
    const Vector3d L = world.body().inertia() * world.body().w;
    const double energy = world.energy().kinetic;
    for (int k = 0; k < 900; ++k) world.advance(1.0 / 90, {});
    EXPECT_LT((world.body().inertia() * world.body().w - L).norm(), 1e-12 * L.norm()) << order;
    // 900 steps of 1e-15, and 1e-12 for a spin within 1e-6 of an axis.
    EXPECT_NEAR(world.energy().kinetic / energy, 1, 5e-12) << order;
  }
}

TEST(Bodies, GiveTheSameBitsAgainAndForAnyOrderOfBodies) {
  Scene scene = blocks(4, 3);
  const auto path = [](double t) -> Vector3d { return {0, 0.3 * std::max(t, 0.0), 0}; };
  scene.hands = {finger(path, {0.002, -0.06, 0.035}, 0.5)};  // pokes the tower over
  std::vector<int> order(scene.bodies.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<Vector3d> first;
  for (int repeat = 0; repeat < 20; ++repeat) {
    Scene shuffled = scene;
    for (std::size_t i = 0; i < order.size(); ++i) shuffled.bodies[i] = scene.bodies[std::size_t(order[i])];
    World world = started(shuffled, {.substeps = 1}, 1.0 / 90);
    run(world, shuffled, 25, 1.0 / 90);
    std::vector<Vector3d> places(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) places[std::size_t(order[i])] = world.bodies()[i].X_WO.p;
    if (repeat == 0) {
      first = places;
      double pushed = 0;
      for (std::size_t i = 0; i < first.size(); ++i)
        pushed = std::max(pushed, (first[i] - scene.bodies[i].X_WO.p).norm());
      EXPECT_GT(pushed, 0.01);
    }
    EXPECT_EQ(places, first) << repeat;
    std::rotate(order.begin(), order.begin() + 5, order.end());
    std::swap(order[0], order[7]);
  }
}

/// A hand lifts one block off another: weight passes from body to body and the hand.
TEST(Bodies, AStackOnAPalmIsCarried) {
  Scene scene;
  scene.name = "stack";
  scene.contact = {.stiffness = 500, .damping = 2};
  const auto lift = [](double t) -> Vector3d { return {0, 0, 0.05 * std::max(t, 0.0)}; };
  scene.hands = {catalogue::hand_of({catalogue::palm_patch({}, lift)}, 1)};
  scene.bodies = {touching_block({0.06, 0.06, 0.02}, 0.1, 0.03), touching_block({0.04, 0.04, 0.04}, 0.1, 0.04)};
  scene.bodies[0].X_WO.p.z() = 0.01;
  scene.bodies[1].X_WO.p.z() = 0.04;
  World world = started(scene, {.substeps = 4}, 1.0 / 90);
  run(world, scene, 90, 1.0 / 90);
  const double sag = 0.2 * 9.81 / (8 * 500);
  EXPECT_NEAR(world.bodies()[0].X_WO.p.z(), 0.06 - sag, 1e-5);
  EXPECT_NEAR(world.bodies()[1].X_WO.p.z() - world.bodies()[0].X_WO.p.z(), 0.03, 3e-5);  // m g / (4 to 8 samples k)
  EXPECT_NEAR(world.bodies()[1].v.z(), 0.05, 1e-6);
}

/// A tilted cube comes sideways into the side of a block, a corner 6 mm below the upper edge: from inside the cube, the
/// corner is behind the block's upper face, whose plane would throw the cube up with energy from nowhere.
TEST(Bodies, ACornerTouchesTheFaceThatItComesThrough) {
  Scene scene;
  scene.name = "sideways";
  scene.gravity.setZero();
  Body cube = touching_block({0.06, 0.06, 0.06}, 0.1, 0.06, 0.002);
  cube.X_WO.R = Eigen::AngleAxisd(0.6, Vector3d::UnitX()) * Eigen::AngleAxisd(0.5, Vector3d::UnitY());
  cube.V_WO.v = {-0.3, 0, 0};
  Vector3d lowest = Vector3d::UnitZ();
  for (const Vector3d& p : cube.samples_O)
    if ((cube.X_WO.R * p).z() < lowest.z()) lowest = cube.X_WO.R * p;
  cube.X_WO.p = Vector3d(0.0501, 0, -0.006) - lowest;  // the block's side is x = 0.05
  scene.bodies = {ground({0.1, 0.1, 0.05}), cube};
  World world = started(scene, {.substeps = 1}, 1.0 / 90);
  const double start = world.energy().kinetic;
  int touches = 0;
  for (int k = 1; k <= 6; ++k) {
    world.advance(1.0 / 90, {});
    for (const Event& event : world.events()) {
      if (event.kind != EventKind::touch) continue;
      for (std::size_t slot = 0; slot < world.contacts().size(); ++slot) {
        if (!(world.contacts().id[slot] == event.id)) continue;
        ++touches;
        EXPECT_GT(world.contact(slot).n_W.x(), 0.999) << k;
      }
    }
    EXPECT_LT(world.energy().kinetic, 1.001 * start) << k;
  }
  EXPECT_GT(touches, 0);
}

}  // namespace
}  // namespace handhold::realtime
