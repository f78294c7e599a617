// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/drawn_hand.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include <gtest/gtest.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::compare {
namespace {

constexpr double dt = 1.0 / 90;
constexpr int tip = 5;              // index, distal
constexpr double depth_tol = 1e-6;  // nearest() finds a place to a millionth of a phalanx

/// Height of the fingertip's skin over the face in frame k: a millimetre a frame down from 10.3 mm until frame 20, then
/// up. Inside in frames 11 to 29, 9.7 mm deep at most.
double height(int k) { return k <= 20 ? 0.0103 - 0.001 * k : -0.0097 + 0.001 * (k - 20); }

using Motion = std::function<Pose(int frame)>;

struct Play {
  Scene scene{};
  Recording recording{};
};

/// A finger that pokes straight down on a cube's face, the rest of the hand a metre above it; the cube goes as told.
/// Frames are the knots of the hand's splines, so that its poses there are exact.
Play poke(const Motion& cube, int first = 0, int frames = 120, int frames_beyond_the_hand = 0) {
  const HandModel model = anatomical_hand();
  const Capsule& capsule = model.capsules[tip];
  const PoseFunction hand = [&](double t) {
    const double z = catalogue::edge / 2 + height(first + int(std::lround(t / dt)));
    std::array<Pose, phalanx_count> X_WP;
    for (Pose& X : X_WP) X.p.z() = z + 1;
    const Eigen::Quaterniond down(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitX()));
    X_WP[tip] = {down, {0, 0, z + capsule.half_length + capsule.radius}};
    return X_WP;
  };
  const Trace trace = sample_trace("poke", Side::right, model, hand, 0, frames * dt, 90);
  Play play;
  play.scene.name = "poke";
  play.scene.bodies = {catalogue::block(Eigen::Vector3d::Constant(catalogue::edge), 4 * catalogue::voxel, 0.1, {})};
  play.scene.hands = {{.motion = std::make_shared<TraceSpline>(trace, 0)}};
  for (int k = 0; k <= frames + frames_beyond_the_hand; ++k) {
    const double t = k <= frames ? trace.t[std::size_t(k)] : k * dt;
    play.recording.frames.push_back({.t = t, .bodies = {{.X_WO = cube(first + k)}}});
  }
  return play;
}

Pose at_rest(int) { return {}; }

/// Slides and turns below the finger: its face stays in its plane.
Pose sliding(int k) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(0.01 * k, Eigen::Vector3d::UnitZ())), {0.0002 * k, 0, 0}};
}

/// Exact: the finger is inside in frames 11 to 29, and a contact that is gone for more than 40 ms is let go: 4 frames.
TEST(DrawnHand, IsFrozenFromTheTouchUntilTheObjectIsLeft) {
  for (const DrawnMode mode : {DrawnMode::whole, DrawnMode::finger}) {
    const DrawnHands drawn = draw_hands(poke(sliding).scene, poke(sliding).recording, mode);
    ASSERT_EQ(drawn.hands.size(), 1U);
    ASSERT_EQ(drawn.hands[0].frozen.size(), 1U);
    EXPECT_DOUBLE_EQ(drawn.hands[0].frozen[0].begin, 11 * dt);
    EXPECT_DOUBLE_EQ(drawn.hands[0].frozen[0].end, 33 * dt);
  }
}

TEST(DrawnHand, FrozenIsAConstantPoseOnTheObject) {
  const Play play = poke(sliding);
  for (const DrawnMode mode : {DrawnMode::whole, DrawnMode::finger}) {
    const DrawnHands drawn = draw_hands(play.scene, play.recording, mode);
    const std::vector<HandSample>& samples = drawn.trace.hands[0].samples;
    const auto on_cube = [&](std::size_t k, std::size_t i) { return sliding(int(k)).inverse() * samples[k].X_WP[i]; };
    for (std::size_t k = 12; k < 33; ++k)
      for (std::size_t i = 0; i < phalanx_count; ++i) {
        if (mode == DrawnMode::whole || i / 3 == tip / 3) {
          const Pose then = on_cube(11, i), now = on_cube(k, i);
          EXPECT_LT((now.p - then.p).norm(), 1e-12);  // rounding of lengths of a metre
          EXPECT_LT((now.R.conjugate() * then.R).vec().norm(), 1e-12);
        } else {
          EXPECT_EQ(samples[k].X_WP[i].p, play.scene.hands[0].motion->pose(int(i), drawn.trace.t[k]).p);
        }
      }
  }
}

/// Exact: the finger stops on the face, where its path, straight within a frame, crosses it; tracked it goes 9.7 mm in.
TEST(DrawnHand, StopsOnTheFaceThatTheTrackedHandGoesThrough) {
  const Play play = poke(sliding);
  const DrawnHand hand = draw_hands(play.scene, play.recording, DrawnMode::whole).hands[0];
  EXPECT_NEAR(hand.tracked.depth, 0.0097, depth_tol);
  EXPECT_EQ(hand.tracked.phalanx, tip);
  EXPECT_DOUBLE_EQ(hand.tracked.t, 20 * dt);
  EXPECT_NEAR(hand.drawn.depth, 0, depth_tol);
  EXPECT_TRUE(hand.bound_kept);
}

/// Exact: a hand that starts 9.7 mm inside has nowhere to stop; on a plane it is moved out until it is as deep as the
/// bound.
TEST(DrawnHand, IsNeverDeeperThanTheBound) {
  const Play play = poke(at_rest, 20);
  for (const double bound : {0.0005, 0.002}) {
    const DrawnHands drawn = draw_hands(play.scene, play.recording, DrawnMode::whole, bound);
    EXPECT_NEAR(drawn.hands[0].drawn.depth, bound, depth_tol);
    EXPECT_TRUE(drawn.hands[0].bound_kept);
    EXPECT_EQ(drawn.bound, bound);
  }
}

/// Exact: from frame 33 on the way to the tracked hand, which rises by v dt = 1 mm a frame, is that of a critically
/// damped spring, e(t) = (e0 + (e0' + ω e0) t) exp(−ω t), ω = 2/0.15 s, from e0 = −3.3 mm and e0' = −v, for the drawn
/// hand stood still.
TEST(DrawnHand, GlidesBackAsACriticallyDampedSpring) {
  const double omega = 2 / 0.15, e0 = -height(33), v = 0.001 / dt;
  const auto left = [&](int k) {
    const double t = (k - 33) * dt;
    return (e0 + (omega * e0 - v) * t) * std::exp(-omega * t);
  };
  double longest = 0, change = 0, before = 0;
  for (int k = 34; std::abs(left(k - 1)) > 1e-4; ++k) {  // until it is back to 0.1 mm
    const double way = 0.001 + left(k) - left(k - 1);
    longest = std::max(longest, std::abs(way));
    change = std::max(change, std::abs(way - before));
    before = way;
  }
  const Play play = poke(at_rest);
  const DrawnHand hand = draw_hands(play.scene, play.recording, DrawnMode::whole).hands[0];
  EXPECT_NEAR(hand.release_step, longest, depth_tol);
  EXPECT_NEAR(hand.release_jump, change, depth_tol);
  EXPECT_NEAR(hand.tracked_step, 0.001, 1e-12);
}

TEST(DrawnHand, IsATraceThatLosesTheHandWhereTheTrackerDid) {
  const Play play = poke(at_rest, 0, 15, 5);  // the tracker ends in frame 15, inside
  const DrawnHands drawn = draw_hands(play.scene, play.recording, DrawnMode::whole);
  validate(drawn.trace);
  ASSERT_EQ(drawn.trace.t.size(), 21U);
  for (std::size_t k = 0; k <= 20; ++k) EXPECT_EQ(drawn.trace.hands[0].samples[k].tracked, k <= 15) << k;
  ASSERT_EQ(drawn.hands[0].frozen.size(), 1U);
  EXPECT_DOUBLE_EQ(drawn.hands[0].frozen[0].end, 16 * dt);
}

TEST(DrawnHand, NeedsAHandWithAShape) {
  Scene scene = poke(at_rest).scene;
  scene.hands[0].given.resize(1);
  EXPECT_THROW(check_drawable(scene), InputError);
  scene.hands.clear();
  EXPECT_THROW(check_drawable(scene), InputError);
}

}  // namespace
}  // namespace handhold::compare
