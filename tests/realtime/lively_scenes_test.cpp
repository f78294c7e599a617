// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/scenes/lively_scenes.hpp"

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "tests/realtime/audited_twin.hpp"
#include "tests/realtime/random_grasp.hpp"
#include "tests/realtime/scenes.hpp"

// Scenes without a closed form: nothing explodes, every invariant of step_audit.hpp holds in every sub-step, and what
// comes out makes sense. That is momentum, angular momentum, no adhesion, complementarity, cone, friction power,
// energy, anchors, unit quaternions and free flight.

namespace handhold::realtime {
namespace {

using namespace testing;  // NOLINT: this file's scenes

constexpr double dt = 1.0 / 90;

struct Played {
  AuditTally tally{};
  std::vector<RigidBody> bodies{};
  double fastest{};  // speed of any body at any frame [m/s]
  double spin{};     // [rad/s]
  bool same{true};
  double cone{};  // largest share of a cone's width by which a sample that sticks is outside, as it is shown
};

/// Forces as recordings have them are turned to where anchors and normals are at the end of a frame.
void check_cones(const World& world, const Scene& scene, Played& run) {
  for (std::size_t slot = 0; slot < world.contacts().size(); ++slot) {
    if (world.contacts().mode[slot] != Mode::stick) continue;
    const ContactState c = world.contact(slot);
    Friction friction = scene.bodies[c.id.body].friction;
    if (c.id.belongs_to_body()) friction = combined(friction, scene.bodies[c.id.phalanx].friction);
    const double N = -c.f_W.dot(c.n_W), width = friction.mu_static * N;
    run.cone = std::max(run.cone, width > 0 ? (c.f_W + N * c.n_W).norm() / width - 1 : 1);
  }
}

Played play(const Scene& scene, double duration, int substeps) {
  AuditedTwin twin(scene, {.substeps = substeps}, dt, {frames(scene, -2 * dt), frames(scene, -dt), frames(scene, 0)});
  Played run;
  for (int k = 1; k <= int(std::lround(duration / dt)); ++k) {
    twin.advance(frames(scene, k * dt));
    run.same = run.same && twin.agrees();
    check_cones(twin.world(), scene, run);
    for (const RigidBody& b : twin.world().bodies()) {
      run.fastest = std::max(run.fastest, b.v.norm());
      run.spin = std::max(run.spin, b.w.norm());
    }
  }
  run.tally = twin.tally();
  run.bodies = twin.world().bodies();
  return run;
}

void expect_invariants(const Played& run, const std::string& name) {
  const AuditTally& t = run.tally;
  EXPECT_TRUE(run.same) << name;
  EXPECT_EQ(t.fault, "") << name;
  EXPECT_EQ(t.unconverged, 0) << name;
  EXPECT_LT(run.cone, 1e-12) << name;
  std::cout << name << ": " << t.steps << " sub-steps, " << t.audited << " with their energy, " << t.unconverged
            << " not solved; " << t.forces << " forces, " << t.slides << " sliding; share of the allowed: momentum "
            << t.momentum << ", cone " << t.cone << ", element " << t.element << ", energy " << t.energy << ", touch "
            << t.touch << "; gain " << t.gain << " of " << t.throughput << " J, fastest " << run.fastest << " m/s, "
            << run.spin << " rad/s\n";
}

TEST(LivelyScenes, ABoxIsShakenInAHand) {
  const Scene scene = catalogue::box_in_hand();
  const Played run = play(scene, scene.duration, 2);
  expect_invariants(run, scene.name);
  EXPECT_GT(run.tally.slides, 100);
  // The hand's own speed is at most 2π (0.03·3, 0.02·2.3, 0.035·3.7) m/s, 1.05 together, and 0.05 m times its turning.
  EXPECT_LT(run.fastest, 3);
  EXPECT_LT(run.bodies[0].X_WO.p.norm(), 0.1);  // still in the hand
}

TEST(LivelyScenes, ACubeGoesFromHandToHand) {
  const Scene scene = catalogue::hand_to_hand();
  const Played run = play(scene, scene.duration, 2);
  expect_invariants(run, scene.name);
  // Where the second hand has carried it: turned by 1 rad about the vertical and moved; the grip gives by millimetres.
  const Vector3d end = Eigen::AngleAxisd(1, Vector3d::UnitZ()) * Vector3d(0, 0, 0.1) + Vector3d(0.15, 0.1, 0.05);
  EXPECT_LT((run.bodies[0].X_WO.p - end).norm(), 0.01);
}

TEST(LivelyScenes, ATowerIsKnockedOver) {
  const Scene scene = catalogue::knocked_tower();
  const Played run = play(scene, scene.duration, 2);
  expect_invariants(run, scene.name);
  double moved = 0;
  for (std::size_t i = 1; i < run.bodies.size(); ++i) {
    moved = std::max(moved, (run.bodies[i].X_WO.p - scene.bodies[i].X_WO.p).norm());
    EXPECT_GT(run.bodies[i].X_WO.p.z(), 0.01) << i;  // none in the ground
  }
  EXPECT_GT(moved, 0.05);
  EXPECT_LT(run.fastest, 4);  // from 0.3 m: 2.4 m/s; from the hand: 0.9 m/s, twice that if it bounces
}

TEST(LivelyScenes, AnAxeSmashesATower) {
  const catalogue::BenchmarkScene made = catalogue::benchmark_scene("S4a");
  const Played run = play(made.scene, 1.6, 2);
  expect_invariants(run, made.scene.name);
  double moved = 0;
  for (std::size_t i = 1; i < run.bodies.size(); ++i)
    moved = std::max(moved, (run.bodies[i].X_WO.p - made.scene.bodies[i].X_WO.p).norm());
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(run.fastest, 10);  // the head comes at 0.6 m · 1.875 · 2π/3 / 0.5 s = 4.7 m/s
}

/// Into hollow corners, where the plane of a face goes on inside the next wall: of an L, and of a cup whose middle is
/// no part of it.
TEST(LivelyScenes, CubesAreThrownIntoCorners) {
  Random random(1);
  Body l_shape = ground(), cup = ground();
  l_shape.field = voxelize(make_l_shape(0.2, 0.2, 0.05, 0.2), {.voxel_size = 0.002});
  cup.field = voxelize(make_cup(0.08, 0.08, 0.01), {.voxel_size = 0.002});
  l_shape.X_WO = {Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitX())), Vector3d::Zero()};  // y is up
  cup.X_WO = {};
  const Vector3d hollow =
      l_shape.X_WO * (l_shape.field->bounds().min().cwiseProduct(Vector3d(1, 1, 0)) + Vector3d(0.05, 0.05, 0));
  for (int i = 0; i < 60; ++i) {
    const bool into_cup = i % 2 == 0;
    Body cube = touching_block({0.04, 0.04, 0.04}, 0.1, 0.04, 0.002);
    cube.X_WO.R = rotation_by(random.in_ball(i % 4 < 2 ? 0 : 0.6));
    cube.V_WO.w = random.in_ball(i % 3 == 0 ? 0 : 10);
    const Vector3d aside = random.in_ball(0.02);
    if (into_cup) {
      cube.X_WO.p = Vector3d(aside.x(), aside.y(), 0.03);
      cube.V_WO.v = Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), -1);
    } else {
      cube.X_WO.p = hollow + Vector3d(0.05, 0, 0.05) + aside;
      cube.V_WO.v = Vector3d(-random.uniform(0.5, 2.5), 0, -random.uniform(0.1, 1.9));
    }
    Scene scene;
    scene.name = into_cup ? "into a cup" : "into an L";
    scene.bodies = {into_cup ? cup : l_shape, cube};
    AuditedTwin twin(scene, {.substeps = 1 + i % 3, .order = 1 + (i / 2) % 2}, dt, {{}, {}, {}});
    for (int k = 0; k < 60; ++k) twin.advance({});
    EXPECT_EQ(twin.tally().fault, "") << scene.name << ", throw " << i;
    EXPECT_EQ(twin.tally().unconverged, 0) << scene.name << ", throw " << i;
    EXPECT_GT(twin.tally().forces, 0) << scene.name << ", throw " << i;
  }
}

TEST(LivelyScenes, JengaStands) {
  const catalogue::BenchmarkScene made = catalogue::benchmark_scene("S4b");
  const Played run = play(made.scene, 1, 2);
  expect_invariants(run, made.scene.name);
  for (std::size_t i = 1; i < run.bodies.size(); ++i)
    EXPECT_LT((run.bodies[i].X_WO.p - made.scene.bodies[i].X_WO.p).norm(), 1e-3) << i;
}

}  // namespace
}  // namespace handhold::realtime
