// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/placing_trial.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/built_grasps.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/mass_properties.hpp"
#include "compare/engine/auto_contact.hpp"
#include "compare/engine/engines.hpp"
#include "compare/study/grasp_table.hpp"
#include "compare/study/substeps.hpp"

namespace handhold::compare {
namespace {

Body body_of(const std::string& shape, double density = 700) {
  Body body;
  body.name = shape;
  body.field = voxelize(make_shape(shape), {0.002, 0.012});
  const SolidProperties solid = solid_properties(body.field->mesh());
  body.inertia = {density * solid.volume, solid.center, density * solid.inertia};
  body.friction = {0.46, 0.37};
  return body;
}

GraspTableOptions real_time() {
  GraspTableOptions options;
  options.engines = {"realtime"};
  options.make_engine = make_engine;
  options.contact_of = [](const Body& body, const Placement& placement) { return auto_contact(body, placement, 8); };
  options.tried = 6;
  return options;
}

GraspPair pair_of(std::size_t grasp, const Body& body) {
  const Trace trace = built_grasps().at(grasp);
  return {trace.name, std::make_shared<const Trace>(trace), 0, body};
}

// The tenth of the table that continuous integration plays. Two fingers hold the box. Of round things they lose some,
// as the table says: then it has been asked what would hold.
TEST(GraspTable, WhatIsTriedIsWhatIsPlayed) {
  for (const std::string shape : {"box", "cylinder", "bottle"}) {
    const GraspRow row = play_grasp(pair_of(0, body_of(shape)), real_time());
    ASSERT_TRUE(row.placing) << row.refused;
    const TriedPlacement& best = row.placing->tried.front();
    if (shape == "box") {
      EXPECT_TRUE(best.trial.held);
    }
    EXPECT_EQ(row.placing->remedy.has_value(), !best.trial.held) << shape;
    EXPECT_EQ(row.engines.front().trial.held, best.trial.held);  // what was tried is what is played
  }
}

/// A recording of the box standing still beside the built hand, in touch until `lost_at`, `way` aside from `moved_at`.
Recording still(const Scene& scene, double lost_at, double moved_at, double way) {
  Recording recording;
  for (int i = 0; i * 0.01 <= scene.duration; ++i) {
    Frame frame{.t = i * 0.01};
    Pose X_WO = scene.bodies.front().X_WO;
    if (frame.t >= moved_at) X_WO.p.z() += way;
    frame.bodies.push_back({X_WO, {}});
    if (frame.t < lost_at) frame.contacts.push_back({.mode = Mode::stick, .depth = 0.001});
    recording.frames.push_back(frame);
  }
  return recording;
}

TEST(JudgeGrasp, LostIsOutOfTouchOrOutOfTheGrip) {
  const Trace trace = built_grasps().at(0);
  Scene scene;
  scene.duration = 0.8;  // the built hand rests until 0.3 s and from 0.8 s: nothing between its tips moves before
  scene.bodies.push_back(body_of("box"));
  scene.bodies.front().held_until = 0.1;
  scene.hands.push_back({std::make_shared<TraceSpline>(trace, 0), {}});
  const double never = 9, until = 0.28;
  EXPECT_TRUE(judge_grasp(scene, still(scene, never, never, 0), 1, until).held);
  const GraspTrial fallen = judge_grasp(scene, still(scene, 0.2, never, 0), 1, until);
  EXPECT_FALSE(fallen.held);
  EXPECT_NEAR(fallen.carried, 0.19 - 0.1, 1e-9);  // the last frame in touch
  EXPECT_TRUE(judge_grasp(scene, still(scene, never, 0.2, 0.9 * most_drift), 1, until).held);
  EXPECT_FALSE(judge_grasp(scene, still(scene, never, 0.2, 1.1 * most_drift), 1, until).held);
}

// n samples at the centre of mass: omega = sqrt(n k / m); at a lever r along x, the turn about y has n k r² / I.
TEST(Substeps, FollowTheFastestMotionOnTheSprings) {
  Scene scene;
  scene.contact.stiffness = 100;
  Body body;
  body.inertia = {0.1, {0, 0, 0}, 1e-4 * Eigen::Matrix3d::Identity()};
  scene.bodies.push_back(body);
  Recording recording;
  Frame frame{.t = 0};
  frame.bodies.push_back({});
  for (std::uint8_t i = 0; i < 16; ++i) {
    ContactState c{.id = {0, 2, 0, i}, .mode = Mode::stick};
    c.C_W = {i % 2 == 0 ? 0.05 : -0.05, 0, 0};
    frame.contacts.push_back(c);
  }
  recording.frames.push_back(frame);
  const double turning = std::sqrt(16 * 100 * 0.05 * 0.05 / 1e-4);
  EXPECT_NEAR(fastest_motion(scene, recording), turning, 1e-9 * turning);
  EXPECT_EQ(needed_substeps(turning, 90), int(std::ceil(turning / (most_phase * 90))));
  EXPECT_EQ(needed_substeps(10, 90), least_substeps);
  EXPECT_EQ(needed_substeps(1e6, 90), most_substeps);
  for (ContactState& c : recording.frames.front().contacts) c.mode = Mode::apart;
  EXPECT_EQ(fastest_motion(scene, recording), 0);
}

}  // namespace
}  // namespace handhold::compare
