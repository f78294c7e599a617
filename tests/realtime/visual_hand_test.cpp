// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/visual_hand.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/placement.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "cases/model/input_error.hpp"
#include "cases/model/patch.hpp"
#include "tests/shared_data.hpp"

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;

constexpr double frame = 1.0 / 90;
constexpr std::size_t tip = 5;  // index, distal

/// A hand far above the face z = 0 (the body's pose is the identity at first) but for the index fingertip.
VisualInput hand_at(const Vector3d& fingertip, const Vector3d& rest = {0, 0, 1}) {
  VisualInput in;
  in.present = true;
  for (Pose& X : in.X_WP) X.p = rest;
  for (PhalanxTouch& touch : in.touch) touch.depth = -1;
  in.X_WP[tip].p = fingertip;
  in.touch[tip] = {fingertip.z() < 0 ? 0 : -1, -fingertip.z()};
  return in;
}

double depth_of(const VisualHand& hand, std::size_t phalanx = tip) { return -hand.poses()[phalanx].p.z(); }

TEST(VisualHand, FreezesWhereTheSkinMetTheFaceHoweverFastItCame) {
  for (const double speed : {0.05, 0.5, 3.0}) {
    VisualHand hand;
    const Pose body;
    for (int k = 0; k < 40; ++k) {
      const double z = 0.0137 + speed * frame * 20 - k * speed * frame;
      hand.advance(frame, hand_at({0, 0, z}), std::span<const Pose>(&body, 1));
      EXPECT_LT(depth_of(hand), 1e-15);  // linear in the depth: exact on a plane
      if (z < 0) {
        EXPECT_NEAR(depth_of(hand), 0, 1e-15);
      }
      EXPECT_EQ(hand.frozen(int(tip)), z < 0);
    }
  }
}

TEST(VisualHand, StandsOnTheObjectAsItMoves) {
  VisualHand hand;
  Pose body;
  hand.advance(frame, hand_at({0, 0, 0.001}), std::span<const Pose>(&body, 1));
  hand.advance(frame, hand_at({0, 0, -0.001}), std::span<const Pose>(&body, 1));
  const std::array<Pose, phalanx_count> at_touch = hand.poses();
  for (int k = 1; k < 50; ++k) {
    body.p = {0.01 * k, 0, 0.002 * k};
    body.R = Eigen::AngleAxisd(0.02 * k, Vector3d(1, 2, 2) / 3);
    VisualInput in = hand_at({0.3, 0, -0.02}, {0.1 * k, 0, 1});  // wherever the tracked hand goes
    hand.advance(frame, in, std::span<const Pose>(&body, 1));
    for (std::size_t i = 0; i < phalanx_count; ++i) {
      EXPECT_LT((hand.poses()[i].p - body * at_touch[i].p).norm(), 1e-14);
      EXPECT_LT(hand.poses()[i].R.angularDistance(body.R * at_touch[i].R), 1e-7);  // acos near 1
    }
  }
}

TEST(VisualHand, PerFingerTheOthersFollowTheTracker) {
  VisualHand hand({.mode = FreezeMode::per_finger});
  const Pose body;
  hand.advance(frame, hand_at({0, 0, 0.001}), std::span<const Pose>(&body, 1));
  const VisualInput in = hand_at({0, 0, -0.005}, {0.2, 0, 1});
  hand.advance(frame, in, std::span<const Pose>(&body, 1));
  for (std::size_t i = 0; i < phalanx_count; ++i) {
    const bool index = 3 <= i && i < 6;
    EXPECT_EQ(hand.frozen(int(i)), index);
    if (!index) {
      EXPECT_EQ(hand.poses()[i].p, in.X_WP[i].p);
    }
  }
}

/// Greatest jump of any phalanx's velocity between frames, over a touch, a second finger's touch and the release, at
/// `rate` frames a second; and where the hand is in the end. Tracked motion is smooth.
struct Smoothness {
  double jump{};  // of velocity, except at the first touch itself [m/s]
  double left{};  // of the way to the tracker, in the end [m]
};

Smoothness play(double rate) {
  VisualHand hand;
  const Pose body;
  const double dt = 1 / rate;
  Smoothness result;
  std::array<std::vector<Vector3d>, phalanx_count> path;
  VisualInput in;
  bool touched = false;
  for (int k = 0; k <= int(2 * rate); ++k) {
    const double t = k * dt, z = 0.02 * std::cos(std::numbers::pi * t);  // inside from 0.5 s to 1.5 s
    in = hand_at({0, 0, z}, {0.1 * std::sin(t), 0, 1});
    in.X_WP[2].p = {0.03 * t, 0, z + 0.01};  // the thumb follows 10 mm behind: inside from 2/3 s to 4/3 s
    in.touch[2] = {z + 0.01 < 0 ? 0 : -1, -(z + 0.01)};
    hand.advance(dt, in, std::span<const Pose>(&body, 1));
    for (std::size_t i = 0; i < phalanx_count; ++i) {
      std::vector<Vector3d>& p = path[i];
      p.push_back(hand.poses()[i].p);
      const bool stops = !touched && hand.frozen(int(i));  // the hand stops dead: that is what freezing is
      if (stops) p.erase(p.begin(), p.end() - 1);
      if (p.size() < 3) continue;
      const std::size_t n = p.size();
      result.jump = std::max(result.jump, ((p[n - 1] - p[n - 2]) - (p[n - 2] - p[n - 3])).norm() / dt);
    }
    touched |= hand.frozen(0);
  }
  for (std::size_t i = 0; i < phalanx_count; ++i)
    result.left = std::max(result.left, (hand.poses()[i].p - in.X_WP[i].p).norm());
  return result;
}

TEST(VisualHand, BlendsAreContinuousInVelocity) {
  // A jump of velocity would stay as the frames get shorter; accelerations make it shrink with dt.
  const double coarse = play(90).jump, fine = play(900).jump;
  EXPECT_GT(coarse, 0);
  EXPECT_LT(fine, coarse / 7);
}

TEST(VisualHand, GlidesBackToTheTracker) {
  // Released 0.46 s before the end: ω t = 6.1, (1 + ω t) e^(−ω t) = 1.6 % of some 5 cm.
  EXPECT_LT(play(90).left, 0.002);
}

TEST(VisualHand, RefinesNoFartherThanItMay) {
  VisualHand hand({.refine_most = 0.004});
  const Pose body;
  VisualInput in = hand_at({0, 0, 0.001});
  in.X_WP[2].p = {0, 0, 0.03};
  in.touch[2].depth = -0.03;
  hand.advance(frame, in, std::span<const Pose>(&body, 1));
  in.X_WP[tip].p.z() = -0.001, in.touch[tip] = {0, 0.001};
  hand.advance(frame, in, std::span<const Pose>(&body, 1));
  const Vector3d before = hand.poses()[2].p;
  in.X_WP[2].p.z() = 0, in.touch[2] = {0, 0};  // the thumb has closed, too: 30 mm from where it froze
  for (int k = 0; k < 200; ++k) hand.advance(frame, in, std::span<const Pose>(&body, 1));
  EXPECT_NEAR((hand.poses()[2].p - before).norm(), 0.004, 1e-9);
}

TEST(VisualHand, AFlickerOfContactIsNoRelease) {
  VisualHand hand({.linger = 0.04});
  const Pose body;
  hand.advance(frame, hand_at({0, 0, 0.001}), std::span<const Pose>(&body, 1));
  hand.advance(frame, hand_at({0, 0, -0.001}), std::span<const Pose>(&body, 1));
  for (int k = 0; k < 3; ++k) hand.advance(frame, hand_at({0, 0, 0.002}), std::span<const Pose>(&body, 1));
  EXPECT_TRUE(hand.frozen(0));
  hand.advance(frame, hand_at({0, 0, 0.002}), std::span<const Pose>(&body, 1));
  EXPECT_FALSE(hand.frozen(0));
}

/// A block with a groove along y, whose walls stand at 60 degrees to each other.
Mesh grooved_block() {
  const double a = 0.03, depth = a * std::sqrt(3.0), bottom = -0.08, length = 0.05;
  Mesh mesh;
  for (const double y : {-length, length})
    for (const Vector3d& p : {Vector3d(-a, y, bottom), Vector3d(a, y, bottom), Vector3d(a, y, 0),
                              Vector3d(0, y, -depth), Vector3d(-a, y, 0)})
      mesh.vertices.push_back(p);
  for (const auto& [p, q, r] : std::vector<std::array<int, 3>>{{0, 1, 3}, {1, 2, 3}, {0, 3, 4}}) {
    mesh.triangles.push_back({p, q, r});
    mesh.triangles.push_back({p + 5, r + 5, q + 5});
  }
  for (int i = 0; i < 5; ++i) {
    const int next = (i + 1) % 5;
    mesh.triangles.push_back({i, i + 5, next});
    mesh.triangles.push_back({next, i + 5, next + 5});
  }
  return mesh;
}

/// A phalanx 5 mm deep in both walls of a groove: moved 4.5 mm out of one it is deeper in the other by cos 60° of that,
/// 6.75 mm too deep, which halves with every further try: below 1 µm after 13.
TEST(VisualHand, IsKeptOutOfAGrooveToo) {
  const auto field = voxelize(grooved_block(), {.voxel_size = 0.001});
  HandModel model = anatomical_hand();
  model.capsules[tip] = {.half_length = 0.005, .radius = 0.008};
  std::array<Pose, phalanx_count> poses;
  for (Pose& X : poses) X.p.z() = 1;
  poses[tip] = {Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX())),
                {0, 0, -0.03 * std::sqrt(3.0) + 0.006}};  // 6 mm · sin 30° from the walls, for a radius of 8 mm
  const auto depth = [&] { return -nearest(model.shape(int(tip)), poses[tip], *field).distance; };
  ASSERT_NEAR(depth(), 0.005, 0.0005);  // half a voxel: near an edge the field rounds it off
  keep_out(model, *field, {}, 0.0005, poses);
  EXPECT_LT(depth(), 0.0005 + 1e-6);
}

TEST(VisualHand, RefusesTimesOfNothing) {
  EXPECT_THROW(VisualHand({.release_time = 0}), InputError);
  EXPECT_THROW(VisualHand({.refine_time = -1}), InputError);
}

// --- recorded hands --------------------------------------------------------------------------------------------------

struct Depths {
  double tracked{}, drawn{}, drawn_standing{}, kept_out{};  // deepest of any phalanx [m]
  bool ever_frozen{};
};

/// A recording around an object that stays where it was put: how deep are the tracked and the drawn hands?
Depths record(const std::string& name, const Mesh& mesh, FreezeMode mode) {
  Depths deepest;
  const auto field = voxelize(mesh, {.voxel_size = 0.001});
  const Trace trace = read_trace(test::shared_data("traces/leapjs/" + name));
  const Placement placement = place_in_hand(trace, 0, *field);
  const TraceSpline motion(trace, 0);
  const Pose X_OW = placement.X_WO.inverse();
  VisualHand hand({.mode = mode});
  const auto depth = [&](int i, const Pose& X_WP) {
    return -nearest(motion.model().shape(i), X_OW * X_WP, *field).distance;
  };
  for (double t = placement.start; t < placement.closure + 1.5; t += frame) {
    VisualInput in;
    in.present = motion.present(t);
    for (int i = 0; i < phalanx_count && in.present; ++i) {
      in.X_WP[std::size_t(i)] = motion.pose(i, t);
      const double d = depth(i, in.X_WP[std::size_t(i)]);
      in.touch[std::size_t(i)] = {d > 0 ? 0 : -1, d};
      deepest.tracked = std::max(deepest.tracked, d);
    }
    std::array<Pose, phalanx_count> poses = hand.advance(frame, in, std::span<const Pose>(&placement.X_WO, 1));
    if (!in.present) continue;
    for (int i = 0; i < phalanx_count; ++i) {
      const double d = depth(i, poses[std::size_t(i)]);
      deepest.drawn = std::max(deepest.drawn, d);
      if (hand.frozen(i) && !hand.blending(i)) deepest.drawn_standing = std::max(deepest.drawn_standing, d);
      deepest.ever_frozen |= hand.frozen(i);
    }
    keep_out(motion.model(), *field, placement.X_WO, 0.0005, poses);
    for (int i = 0; i < phalanx_count; ++i)
      deepest.kept_out = std::max(deepest.kept_out, depth(i, poses[std::size_t(i)]));
  }
  return deepest;
}

TEST(VisualHand, RecordedGraspsAreNotDrawnInsideTheObject) {
  if (!std::ifstream(test::shared_data("traces/leapjs/pinch.json.lz"))) GTEST_SKIP() << "the shared data are not here";
  for (const char* name : {"pinch.json.lz", "grab.json.lz"}) {
    for (const FreezeMode mode : {FreezeMode::whole_hand, FreezeMode::per_finger}) {
      for (const Mesh& mesh : {make_box({0.03, 0.03, 0.03}), make_cylinder(0.02, 0.06)}) {
        const Depths d = record(name, mesh, mode);
        const std::string where = std::string(name) + (mode == FreezeMode::whole_hand ? " whole" : " fingers");
        EXPECT_TRUE(d.ever_frozen) << where;
        EXPECT_GT(d.tracked, 0.002) << where;
        EXPECT_LT(d.kept_out, 0.0005 + 1e-6) << where;  // its bound; 1e-6: nearest()'s resolution
        // Where the hand stands still: the curvature of one frame's path. A regression bound, measured 0.16 mm in grab
        // (fingers); a path of 3 mm a frame on a radius of 20 mm gives 3² / (8 · 20) = 0.06 mm and its turn as much.
        EXPECT_LT(d.drawn_standing, 0.00025) << where;
        // Blends: half of refine_most, or half of the way back to a tracked hand that went through, however deep that
        // is where the object was placed.
        EXPECT_LT(d.drawn, std::max(0.01, 0.5 * d.tracked)) << where;
      }
    }
  }
}

}  // namespace
}  // namespace handhold::realtime
