// SPDX-License-Identifier: GPL-3.0-or-later
// Variants of runs, and what a change does to what is not simulated here.
#include "cases/catalogue/builders/variants.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cases/catalogue/builders/block_field.hpp"
#include "cases/catalogue/builders/changed.hpp"
#include "cases/catalogue/builders/scenes.hpp"

namespace handhold::catalogue {
namespace {

using Eigen::Vector3d;

const Change odd{.length = 4,
                 .mass = 3,
                 .mirrored = true,
                 .X = {Eigen::Quaterniond(Eigen::AngleAxisd(2, Vector3d(2, -1, 3).normalized())), {0.3, -0.5, 0.7}},
                 .boost = {0.5, -0.2, 1}};

TEST(Change, IsUndone) {
  const BodyState state{{Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized())), {0.1, 0.2, 0.3}},
                        {{1, -2, 3}, {0.4, 0.5, -0.6}}};
  const double t = 0.8;
  const BodyState back = odd.old({odd.pose(state.X_WO, t), odd.twist(state.V_WO)}, t);
  EXPECT_LT((back.X_WO.p - state.X_WO.p).norm(), 1e-15);
  EXPECT_LT(back.X_WO.R.angularDistance(state.X_WO.R), 1e-14);
  EXPECT_LT((back.V_WO.v - state.V_WO.v).norm(), 1e-15);
  EXPECT_LT((back.V_WO.w - state.V_WO.w).norm(), 1e-15);
}

/// The twist of a changed hand is the rate of its changed pose.
TEST(Change, MovesAHandAsItsPoseSays) {
  const Path path = [](double t) -> Vector3d { return {0.1 * t * t, 0.02 * t, 0}; };
  const Hand hand = changed(hand_of({palm_patch({}, path)}, 1), odd);
  const double t = 0.9, h = 1e-5;
  const Vector3d rate = (hand.motion->pose(palm, t + h).p - hand.motion->pose(palm, t - h).p) / (2 * h);
  EXPECT_LT((hand.motion->twist(palm, t).v - rate).norm(), 1e-8);
  EXPECT_TRUE(hand.motion->present(2));  // of two seconds, by the root of the length
}

/// In a mirror a body turns the other way about a mirrored axis: points of it move as the mirror shows them.
TEST(Change, MirrorsSpins) {
  const Change mirror{.mirrored = true};
  const Vector3d w(1, 2, 3), arm(0.3, -0.1, 0.2);
  EXPECT_LT((mirror.polar(w.cross(arm)) - mirror.axial(w).cross(mirror.polar(arm))).norm(), 1e-15);
}

TEST(ChangedProblem, AsksItsLoadAboutTheOldBody) {
  RigidProblem problem;
  problem.load = [](double t, const BodyState& body) -> Load { return {t * body.V_WO.v + body.X_WO.p, body.V_WO.w}; };
  problem.V_WB = {{0.1, 0.2, 0.3}, {1, 2, 3}};
  problem.X_WB.p = {0.5, 0.6, 0.7};
  problem.supports = {{.surface = make_plane({0, 0, 1}, {0, 1, 1})}, {.surface = make_sphere({1, 2, 3}, 0.5)}};
  Change change = odd;
  change.reversed = true;
  const RigidProblem made = changed(problem, change);
  const double t = 0.3;
  const Load was = problem.load(t, {problem.X_WB, problem.V_WB});
  const Load is = made.load(t * change.time(), {change.pose(problem.X_WB, t * change.time()), made.V_WB});
  EXPECT_LT((is.force_W - 3 * change.polar(was.force_W)).norm(), 1e-14);
  EXPECT_LT((is.torque_W - 12 * change.axial(was.torque_W)).norm(), 1e-14);
  // The body is as far from its surfaces as it was, in the new lengths; the last support comes first.
  EXPECT_NEAR(proximity(made.supports[1].surface, made.X_WB.p).distance,
              4 * proximity(problem.supports[0].surface, problem.X_WB.p).distance, 1e-14);
  EXPECT_NEAR(proximity(made.supports[0].surface, made.X_WB.p).distance,
              4 * proximity(problem.supports[1].surface, problem.X_WB.p).distance, 1e-14);
}

TEST(ChangedField, IsTheMirrorImage) {
  const auto field = block_field({0.05, 0.04, 0.03}, 0.002);
  const auto image = changed(*field, {.mirrored = true});
  for (const Vector3d& p : {Vector3d(0.01, 0.019, 0.004), Vector3d(0.027, -0.013, 0.0), Vector3d(0.001, 0.018, 0.02)}) {
    const Vector3d q(p.x(), -p.y(), p.z());
    EXPECT_FLOAT_EQ(float(field->distance(p).distance), float(image->distance(q).distance));
    EXPECT_NEAR(field->closest(p, 0.02)->distance, image->closest(q, 0.02)->distance, 1e-15);
  }
}

TEST(BlockField, IsSharedByThoseWhoAskForTheSame) {
  const auto a = block_field({0.05, 0.04, 0.03}, 0.002);
  EXPECT_EQ(a, block_field({0.05, 0.04, 0.03}, 0.002));
  EXPECT_NE(a, block_field({0.05, 0.04, 0.03}, 0.001));
}

TEST(Variants, FollowThePlainRunsWithTheSameTruth) {
  for (const Case& c : all_cases()) {
    if (c.level == Level::printed) continue;  // its voxels and rays have no other look
    std::size_t plain = 0;
    while (plain < c.runs.size() && c.runs[plain].variant.empty()) ++plain;
    ASSERT_EQ(c.runs.size(), 2 * plain) << c.id;
    for (std::size_t i = plain; i < c.runs.size(); ++i) {
      const catalogue::Run &run = c.runs[i], &old = c.runs[i % plain];
      EXPECT_EQ(run.name, old.name);
      EXPECT_EQ(run.variant, "turned, mirrored, reordered");
      EXPECT_FALSE(run.curve);
      ASSERT_EQ(run.claims.size(), old.claims.size());
      for (std::size_t k = 0; k < run.claims.size(); ++k) EXPECT_EQ(run.claims[k].truth, old.claims[k].truth);
    }
  }
}

}  // namespace
}  // namespace handhold::catalogue
