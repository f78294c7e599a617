// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/log/log_judge.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/built_grasps.hpp"
#include "cases/hand/hand_skeleton.hpp"
#include "cases/hand/placement.hpp"
#include "cases/hand/trace_builder.hpp"
#include "compare/engine/engines.hpp"
#include "compare/log/log_replay.hpp"
#include "compare/study/placing_trial.hpp"

namespace handhold::compare {
namespace {

using Eigen::Vector3d;
using Path = std::function<Vector3d(double t)>;

constexpr double edge = 0.05, rate = 90, length = 2;
constexpr int index_distal = 5;

const Vector3d palm_W(0, 0, 1);

/// Stretched fingers along x, the back of the hand up.
std::array<Pose, phalanx_count> stretched(const Vector3d& p_WPalm) {
  Eigen::Matrix3d R;  // palm: z to the fingers, y to its back, x to the thumb
  R << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  return forward_kinematics(anatomical_hand(), Side::right, {Eigen::Quaterniond(R), p_WPalm}, {});
}

LoggedSolid cube() {
  static const LoggedSolid solid = [] {
    const auto field = voxelize(make_box({edge, edge, edge}));
    return LoggedSolid{"cube", field, solid_properties(field->mesh())};
  }();
  return solid;
}

/// A cube on a path, logged from 0 to 2 s; with a hand on a path of its palm, if one is given.
ObjectLog log_of(const Path& path, const Path& hand = {}) {
  ObjectLog log;
  LoggedObject object{.name = "cube"};
  for (int i = 0; i <= int(rate * length); ++i) {
    log.t.push_back(i / rate);
    object.X_WO.emplace_back(Pose{Eigen::Quaterniond::Identity(), path(i / rate)});
  }
  log.objects = {object};
  if (hand)
    log.trace = sample_trace(
        "hand", Side::right, anatomical_hand(), [&](double t) { return stretched(hand(t)); }, 0, length, rate);
  return log;
}

LogReport judged(const ObjectLog& log) {
  const std::vector<LoggedSolid> solids{cube()};
  return judge_log(log, tracks_of(log, solids), solids);
}

const LogFinding* found(const LogReport& report, LogFault fault) {
  for (const LogFinding& finding : report.findings)
    if (finding.fault == fault) return &finding;
  return nullptr;
}

/// The cube's centre when its top face is `depth` inside the index finger's tip.
Vector3d below_the_index(double depth, const Vector3d& p_WPalm = palm_W) {
  const double radius = anatomical_hand().capsules[index_distal].radius;
  return stretched(p_WPalm)[index_distal].p - Vector3d(0, 0, edge / 2 + radius - depth);
}

Path still(const Vector3d& p) {
  return [p](double) { return p; };
}

TEST(JudgeLog, FindsNothingInWhatRests) { EXPECT_TRUE(judged(log_of(still({0, 0, 0.3}))).findings.empty()); }

TEST(JudgeLog, FindsNothingInAThrowThatLands) {
  // Up with 3 m/s, down to the floor at z = 0, where it stays.
  const LogReport report = judged(log_of([](double t) {
    const double z = 0.2 + 3 * t - 9.81 / 2 * t * t;
    return Vector3d(0.5 * std::min(t, 0.6725), 0, std::max(z, 0.0));
  }));
  EXPECT_TRUE(report.findings.empty()) << report.findings.front().text;
}

TEST(JudgeLog, FindsAFallThatIsTooSlow) {
  const LogReport report = judged(log_of([](double t) { return Vector3d(0, 0, 20 - 4.2 / 2 * t * t); }));
  const LogFinding* flight = found(report, LogFault::flight);
  ASSERT_NE(flight, nullptr);
  EXPECT_NEAR(flight->value, 9.81 - 4.2, 0.02);
  EXPECT_EQ(report.findings.size(), 1u);  // one flight is one finding
}

TEST(JudgeLog, FindsAJumpAtItsFrame) {
  const LogReport report = judged(log_of([](double t) { return Vector3d(t < 1.005 ? 0 : 0.3, 0, 0.3); }));
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].fault, LogFault::jump);
  EXPECT_NEAR(report.findings[0].value, 0.3, 1e-9);
  EXPECT_NEAR(report.findings[0].end, 1.005, 1 / rate);
}

TEST(JudgeLog, FindsSinking) {
  const LogReport report = judged(log_of([](double t) { return Vector3d(0, 0, 0.3 - 0.003 * t); }));
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].fault, LogFault::drift);
  EXPECT_NEAR(report.findings[0].value, 0.003, 1e-6);
  EXPECT_NE(report.findings[0].text.find("sinks"), std::string::npos);
}

TEST(JudgeLog, AllowsRoundingToATenthOfAMillimetre) {
  const auto rounded = [](double x) { return 1e-4 * std::round(1e4 * x); };
  const LogReport rest = judged(log_of([&](double t) { return Vector3d(rounded(2e-5 * std::sin(40 * t)), 0, 0.3); }));
  EXPECT_TRUE(rest.findings.empty());
  const LogReport flight = judged(log_of([&](double t) { return Vector3d(0, 0, rounded(30 - 9.81 / 2 * t * t)); }));
  EXPECT_TRUE(flight.findings.empty()) << flight.findings.front().text;
}

TEST(JudgeLog, FindsCreepInAStillHandAndNoneInOneThatHolds) {
  EXPECT_TRUE(judged(log_of(still(below_the_index(0.001)), still(palm_W))).findings.empty());
  const LogReport report = judged(
      log_of([](double t) { return Vector3d(below_the_index(0.001) + Vector3d(0, 0.002 * t, 0)); }, still(palm_W)));
  const LogFinding* creep = found(report, LogFault::creep);
  ASSERT_NE(creep, nullptr);
  EXPECT_NEAR(creep->value, 0.002, 1e-6);
  ASSERT_EQ(report.grips.size(), 1u);
  EXPECT_LT(report.grips[0].jitter, 1e-9);
}

TEST(JudgeLog, FindsAKickAtRelease) {
  // The hand rises at 0.2 m/s from 1 s on; the cube flies off sideways at 2 m/s, or at 0.3.
  const auto report = [](double speed) {
    return judged(log_of(
        [=](double t) {
          const double s = std::max(0.0, t - 1);
          return Vector3d(below_the_index(0.001) + Vector3d(0, speed * s, -9.81 / 2 * s * s));
        },
        [](double t) { return Vector3d(palm_W + Vector3d(0, 0, 0.2 * std::max(0.0, t - 1))); }));
  };
  const LogReport kicked = report(2);
  const LogFinding* kick = found(kicked, LogFault::kick);
  ASSERT_NE(kick, nullptr);
  EXPECT_NEAR(kick->begin, 1.01, 3 / rate);
  EXPECT_EQ(found(report(0.3), LogFault::kick), nullptr);
}

TEST(JudgeLog, FindsABoneInsideADrawnHandsObject) {
  const auto drawn = [](double depth) {
    ObjectLog log = log_of(still(below_the_index(depth)), still(palm_W));
    EXPECT_EQ(found(judged(log), LogFault::penetration), nullptr);  // a tracked hand may be inside
    log.drawn_hands = true;
    return judged(log);
  };
  const LogReport deep = drawn(0.012);
  const LogFinding* inside = found(deep, LogFault::penetration);
  ASSERT_NE(inside, nullptr);
  EXPECT_NE(inside->text.find("index"), std::string::npos);
  EXPECT_EQ(found(drawn(0.003), LogFault::penetration), nullptr);
}

/// What the real-time path makes of a built grasp, as a log.
struct PlayedGrasp {
  Trace trace = built_grasps().at(0);
  Body body{};
  ObjectLog log{};
  std::vector<LoggedSolid> solids{};
  double let_go{};  ///< the support ends [s]

  explicit PlayedGrasp(double mu = 0.46) {
    body.name = "cylinder";
    body.field = voxelize(make_cylinder(0.03, 0.12));
    const SolidProperties solid = solid_properties(body.field->mesh());
    body.inertia = {300 * solid.volume, solid.center, 300 * solid.inertia};
    body.friction = {mu, mu};
    const PlacingRequest request{.trace = &trace, .body = body, .contact = {400, 2}, .tried = 4};
    const Placing placing = place_by_trial(request, *make_engine("realtime"));
    const TriedPlacement& best = placing.tried.front();
    const Recording recording = make_engine("realtime")->play(scene_of(request, best.placement, best.contact), {});
    LoggedObject object{.name = "cylinder"};
    for (const Frame& frame : recording.frames) {
      log.t.push_back(best.placement.start + frame.t);
      object.X_WO.emplace_back(frame.bodies[0].X_WO);
    }
    log.objects = {object};
    log.trace = trace;
    solids = {{"cylinder", body.field, solid}};
    let_go = best.placement.held_until;
  }
};

TEST(JudgeLog, FindsNothingInAGraspThatOurEnginePlayed) {
  const PlayedGrasp played;
  const std::vector<ObjectTrack> tracks = tracks_of(played.log, played.solids);
  const LogReport report = judge_log(played.log, tracks, played.solids);
  for (const LogFinding& finding : report.findings) ADD_FAILURE() << finding.begin << " s: " << finding.text;
  ASSERT_EQ(report.grips.size(), 1u);
  const auto contact = [](const Placement&) { return ContactParameters{400, 2}; };
  const auto replay =
      replay_grip(played.log, tracks[0], report.grips[0], played.body, contact, *make_engine("realtime"));
  ASSERT_TRUE(replay.has_value());
  const double end = replay->replayed_end.value_or(replay->played_until);
  EXPECT_NEAR(end, report.grips[0].end, 0.1);

  // The same log with an object on ice: the law of friction says that it cannot have been held.
  Body ice = played.body;
  ice.friction = {0.02, 0.02};
  const auto slipped = replay_grip(played.log, tracks[0], report.grips[0], ice, contact, *make_engine("realtime"));
  ASSERT_TRUE(slipped && slipped->replayed_end);
  EXPECT_LT(*slipped->replayed_end, report.grips[0].end - 0.3);
}

}  // namespace
}  // namespace handhold::compare
