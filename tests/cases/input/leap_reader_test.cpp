// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/leap_reader.hpp"

#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cases/hand/trace_spline.hpp"
#include "cases/input/text_file.hpp"
#include "cases/input/trace/joint_frames.hpp"
#include "cases/input/trace/lz_string.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "cases/input/trace/trace_summary.hpp"
#include "tests/cases/input/trace_fixtures.hpp"
#include "tests/shared_data.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using test::contains;
using test::message_of;
using test::starts_with;

/// A flat hand in Leap's frame (mm, y up, -z away from the user), palm down, fingers away: a right thumb is at -x.
json pointable(int hand, int type, double side) {
  const double x = side * (-30 + 20 * (type - 1));
  const double ahead[4] = {0, 40, 65, 82};
  const auto p = [&](int n) {
    return type == 0 ? json{side * (-30 - 0.7 * ahead[n]), 200, -0.7 * ahead[n]} : json{x, 200, -50 - ahead[n]};
  };
  return {{"id", 10 * hand + type}, {"handId", hand},      {"type", type},        {"width", 18},        {"tool", false},
          {"mcpPosition", p(0)},    {"pipPosition", p(1)}, {"dipPosition", p(2)}, {"tipPosition", p(3)}};
}

json hand_of(int id, const std::string& type) {
  return {{"id", id},
          {"type", type},
          {"palmPosition", {0, 200, -5}},
          {"direction", {0, 0, -1}},
          {"palmNormal", {0, -1, 0}},
          {"confidence", 0.75}};
}

json frame_of(double microseconds, int id = 12, const std::string& type = "right") {
  json frame{{"timestamp", microseconds}, {"id", 1000}, {"hands", {hand_of(id, type)}}, {"pointables", json::array()}};
  for (int finger = 0; finger < 5; ++finger) {
    frame["pointables"].push_back(pointable(id, finger, type == "right" ? 1 : -1));
  }
  return frame;
}

json recording_of(json frames) { return {{"metadata", {{"frames", frames.size()}}}, {"frames", std::move(frames)}}; }

Trace read(const json& recording) { return read_leap(recording.dump(), "r.json"); }

// mm, y up -> m, z up is (x, y, z) -> (x, -z, y) / 1000.
TEST(LeapReader, ReadsARawFrame) {
  const Trace trace = read(recording_of({frame_of(7e6), frame_of(7.01e6)}));
  EXPECT_EQ(trace.t[0], 0);
  EXPECT_NEAR(trace.t[1], 0.01, 1e-12);
  ASSERT_EQ(trace.hands.size(), 1u);
  EXPECT_EQ(trace.hands[0].side, Side::right);
  const HandSample& sample = trace.hands[0].samples[0];
  EXPECT_EQ(sample.confidence, 0.75);
  EXPECT_LT((sample.X_WP[3].p - Vector3d(-0.03, 0.07, 0.2)).norm(), 1e-12);
  EXPECT_LT((sample.X_WP[3].R * Vector3d::UnitZ() - Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_LT((sample.X_WP[3].R * Vector3d::UnitY() - Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(trace.hands[0].model.capsules[3].half_length, 0.02, 1e-12);
  EXPECT_NEAR(trace.hands[0].model.capsules[3].radius, 0.009, 1e-12);
  EXPECT_TRUE(trace.warnings.empty());
}

TEST(LeapReader, FingersAreKeyedByTypeNotOrder) {
  json shuffled = frame_of(0);
  std::reverse(shuffled["pointables"].begin(), shuffled["pointables"].end());
  const Trace a = read(recording_of({frame_of(0), frame_of(1e4)})), b = read(recording_of({shuffled, frame_of(1e4)}));
  for (std::size_t i = 0; i < phalanx_count; ++i) {
    EXPECT_EQ(a.hands[0].samples[0].X_WP[i].p, b.hands[0].samples[0].X_WP[i].p) << i;
  }
}

/// The same frames packed: the columns first (nested ones as recording.js writes them).
json packed(const json& raw, const std::vector<std::string>& hand_columns,
            const std::vector<std::string>& finger_columns) {
  json frames = json::array();
  frames.push_back({"id", "timestamp", {{"hands", {hand_columns}}}, {{"pointables", {finger_columns}}}});
  const auto row = [](const json& object, const std::vector<std::string>& columns) {
    json values = json::array();
    for (const std::string& column : columns) values.push_back(object.value(column, json()));
    return values;
  };
  for (const json& frame : raw) {
    json hands = json::array(), fingers = json::array();
    for (const json& hand : frame["hands"]) hands.push_back(row(hand, hand_columns));
    for (const json& finger : frame["pointables"]) fingers.push_back(row(finger, finger_columns));
    frames.push_back({frame["id"], frame["timestamp"], hands, fingers});
  }
  return {{"metadata", {{"formatVersion", 2}}}, {"frames", frames}};
}

const std::vector<std::string> hand_columns{"id", "type", "direction", "palmNormal", "palmPosition", "confidence"};
const std::vector<std::string> finger_columns{"id",          "handId",      "type",        "mcpPosition",
                                              "pipPosition", "dipPosition", "tipPosition", "width"};

TEST(LeapReader, PackedFramesAreTheSame) {
  const json raw{frame_of(0, 3, "left"), frame_of(9000, 3, "left")};
  const Trace a = read(recording_of(raw)), b = read(packed(raw, hand_columns, finger_columns));
  ASSERT_EQ(b.t, a.t);
  EXPECT_EQ(b.hands[0].side, Side::left);
  for (std::size_t i = 0; i < phalanx_count; ++i) {
    EXPECT_EQ(a.hands[0].samples[1].X_WP[i].p, b.hands[0].samples[1].X_WP[i].p) << i;
  }
  EXPECT_EQ(a.hands[0].model.capsules[4].radius, b.hands[0].model.capsules[4].radius);
}

// Older packed files: no type of hand or finger, no width. Side by shape, fingers by order, radii anatomical.
TEST(LeapReader, OldPackedFilesLackTypeAndWidth) {
  for (const std::string side : {"left", "right"}) {
    const json raw{frame_of(0, 3, side), frame_of(9000, 3, side)};
    const Trace trace = read(packed(raw, {"id", "direction", "palmNormal", "palmPosition"},
                                    {"id", "handId", "mcpPosition", "pipPosition", "dipPosition", "tipPosition"}));
    ASSERT_EQ(trace.hands.size(), 1u);
    EXPECT_EQ(trace.hands[0].side == Side::left ? "left" : "right", side);
    EXPECT_NEAR(trace.hands[0].model.capsules[3].half_length, 0.02, 1e-12);
    EXPECT_GT(trace.hands[0].model.capsules[3].radius, 0.007);
    ASSERT_EQ(trace.warnings.size(), 1u);
    EXPECT_TRUE(contains(trace.warnings[0], "2 hands do not say"));
  }
}

TEST(LeapReader, ANewIdAfterALossIsTheSameHand) {
  json empty = frame_of(20000);
  empty["hands"] = json::array();
  const Trace trace = read(recording_of({frame_of(0, 28), frame_of(10000, 28), empty, frame_of(30000, 30)}));
  ASSERT_EQ(trace.hands.size(), 1u);
  EXPECT_FALSE(trace.hands[0].samples[2].tracked);
  EXPECT_TRUE(trace.hands[0].samples[3].tracked);
  ASSERT_EQ(trace.warnings.size(), 1u);
  EXPECT_TRUE(contains(trace.warnings[0], "id changed (28, 30)"));
}

// A ghost half a metre up is seen as a second right hand, before or after the true one in the frame's list.
TEST(LeapReader, ASecondRightHandDoesNotTakeOver) {
  json ghost = frame_of(10000, 40);
  for (json& p : ghost["pointables"]) {
    for (const char* joint : {"mcpPosition", "pipPosition", "dipPosition", "tipPosition"}) p[joint][1] = 500;
  }
  const json followed = frame_of(10000, 12);
  for (const bool ghost_first : {true, false}) {
    json two = ghost_first ? ghost : followed;
    const json& second = ghost_first ? followed : ghost;
    two["hands"].push_back(second["hands"][0]);
    for (const json& p : second["pointables"]) two["pointables"].push_back(p);
    const Trace trace = read(recording_of({frame_of(0), two, frame_of(20000)}));
    EXPECT_NEAR(trace.hands[0].samples[1].X_WP[3].p.z(), 0.2, 1e-12) << ghost_first;
    EXPECT_TRUE(contains(trace.warnings.at(0), "seen twice in 1 frames"));
  }
}

TEST(LeapReader, StaleFrameCountIsAWarning) {
  json recording = recording_of({frame_of(0), frame_of(10000)});
  recording["metadata"]["frames"] = 1058;
  EXPECT_TRUE(contains(read(recording).warnings.at(0), "says 1058, but there are 2"));
}

TEST(LeapReader, BadInput) {
  const auto message = [](const json& recording) { return message_of([&] { return read(recording); }); };
  EXPECT_TRUE(contains(message(json::object({{"metadata", nullptr}})), "there are no frames"));
  json empty = frame_of(0);
  empty["hands"] = json::array();
  EXPECT_TRUE(contains(message(recording_of(json::array({empty}))), "no frame with a whole hand"));
  EXPECT_TRUE(starts_with(message(recording_of({frame_of(10000), frame_of(0)})), "r.json, frame 1: the time stamp"));
  EXPECT_TRUE(starts_with(message(recording_of({frame_of(0), 7})), "r.json, frame 1: is neither"));
  json wide = packed(json::array({frame_of(0)}), hand_columns, finger_columns);
  wide["frames"][1].push_back(1);
  EXPECT_TRUE(starts_with(message(wide), "r.json, frame 1: a packed row does not fit"));
  EXPECT_TRUE(contains(message_of([] { return read_leap("[1]", "r.json"); }), "frame 0: is neither"));
}

// Unpacking, and every copy of a value, follows the nesting: a hostile file must not use up the stack.
TEST(LeapReader, DeeplyNestedColumnsAreRefused) {
  constexpr int levels = 100'000;
  std::string columns, row, end;
  for (int i = 0; i < levels; ++i) columns += "[{\"a\":", row += '[', end += "}]";
  const std::string text =
      "{\"frames\":[" + columns + "[\"x\"]" + end + "," + row + "[1]" + std::string(levels, ']') + "]}";
  EXPECT_TRUE(starts_with(message_of([&] { return read_leap(text, "r.json"); }), "r.json:1, byte "));
}

TEST(LeapReader, WrongKindsOfMembersNeverEscape) {
  const json raw = recording_of({frame_of(0), frame_of(10000)});
  for (const json& good : {raw, packed(raw["frames"], hand_columns, finger_columns)}) {
    const json flat = good.flatten();
    for (const json& junk :
         {json(nullptr), json(1e300), json("text"), json::array(), json::object({{"a", 1}}), json(true)}) {
      for (const auto& [pointer, value] : flat.items()) {
        json bad = good;
        bad[json::json_pointer(pointer)] = junk;
        EXPECT_NO_THROW((void)message_of([&] { return read(bad); })) << pointer << junk;
        bad[json::json_pointer(pointer).parent_pointer()] = junk;
        EXPECT_NO_THROW((void)message_of([&] { return read(bad); })) << pointer << junk;
      }
    }
  }
}

// Recordings of real hands, not in the repository (leapmotion/leapjs-playback, Apache-2.0)
// ------------------------------

std::string recording_path(const std::string& name) { return test::shared_data("traces/leapjs/" + name); }

#define SKIP_WITHOUT(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent"

// Measured by separate means (Python over the original lz-string library's output): 374 frames, 3.304141 s, median tick
// 8.668 ms, jitter 0.084 ms, gaps after frames 18, 87, 99, 211, 336; confidence 0.49 to 1; largest palm step 24.0 mm.
TEST(LeapRecordings, Grab) {
  const std::string path = recording_path("grab.json.lz");
  SKIP_WITHOUT(path);
  const Trace trace = read_trace(path);
  const TraceSummary summary = summarize(trace);
  EXPECT_EQ(summary.frames, 374u);
  EXPECT_NEAR(summary.duration, 3.304141, 1e-9);
  EXPECT_NEAR(summary.tick, 8.668e-3, 2e-6);  // two middle values, 1 µs apart
  EXPECT_NEAR(summary.jitter, 0.084e-3, 0.5e-6);
  ASSERT_EQ(summary.gaps.size(), 5u);
  const std::array<std::size_t, 5> after{18, 87, 99, 211, 336};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(summary.gaps[i].begin, trace.t[after[i]]);
  ASSERT_EQ(summary.hands.size(), 1u);
  EXPECT_EQ(summary.hands[0].side, Side::right);
  EXPECT_EQ(summary.hands[0].tracked, 1);
  EXPECT_NEAR(summary.hands[0].least_confidence, 0.49, 0.005);
  EXPECT_NEAR(summary.hands[0].palm_step, 0.0240, 0.0005);  // our palm's centre lies a few mm off theirs
  // 17, 23, 32 µm on the axes (their rms 24.8), and the 1.16 by which the filter's residual is below white noise.
  EXPECT_NEAR(summary.hands[0].palm_noise, 24.8e-6 * 1.16, 3e-6);
  // The fist of 0.53 to 1.18 s, seen by joint angles instead of by the service's grab strength.
  ASSERT_FALSE(summary.hands[0].fist.empty());
  EXPECT_NEAR(summary.hands[0].fist[0].begin, 0.53, 0.1);
  EXPECT_NEAR(summary.hands[0].fist[0].end, 1.18, 0.15);
}

// Bones in the file, 1.05 times Leap's default table (index 41.5, 25.6, 17.3, width 17.91; little 32, 18.11, 15.96 mm).
TEST(LeapRecordings, GrabHasTheBonesOfItsTable) {
  const std::string path = recording_path("grab.json.lz");
  SKIP_WITHOUT(path);
  const HandModel model = read_trace(path).hands[0].model;
  constexpr double digits = 1e-6;  // the file's six digits
  EXPECT_NEAR(2 * model.capsules[3].half_length, 1.05 * 0.0415, digits);
  EXPECT_NEAR(2 * model.capsules[4].half_length, 1.05 * 0.0256, digits);
  EXPECT_NEAR(2 * model.capsules[0].half_length, 1.05 * 0.0400, digits);
  EXPECT_NEAR(2 * model.capsules[12].half_length, 1.05 * 0.0320, digits);
  EXPECT_NEAR(model.capsules[3].radius, 1.05 * 0.01791 / 2, digits);
}

// Joints of one finger stay rigid through the whole recording: neighbouring capsules meet to 5 µm (sd of the lengths
// 0.3 µm).
TEST(LeapRecordings, GrabIsRigid) {
  const std::string path = recording_path("grab.json.lz");
  SKIP_WITHOUT(path);
  const TraceHand hand = read_trace(path).hands[0];
  for (const HandSample& sample : hand.samples) {
    for (std::size_t i = 0; i < 15; ++i) {
      if (i % 3 == 2) continue;
      const Vector3d end = sample.X_WP[i] * Vector3d(0, 0, hand.model.capsules[i].half_length);
      const Vector3d begin = sample.X_WP[i + 1] * Vector3d(0, 0, -hand.model.capsules[i + 1].half_length);
      ASSERT_LT((end - begin).norm(), 5e-6);
    }
  }
}

TEST(LeapRecordings, Confidence2HasTwoHandsAnd76Gaps) {
  const std::string path = recording_path("confidence2.json.lz");
  SKIP_WITHOUT(path);
  const TraceSummary summary = summarize(read_trace(path));
  EXPECT_EQ(summary.frames, 368u);
  EXPECT_EQ(summary.gaps.size(), 76u);
  ASSERT_EQ(summary.hands.size(), 2u);
  EXPECT_EQ(summary.hands[0].side, Side::left);
  EXPECT_EQ(summary.hands[1].side, Side::right);
}

TEST(LeapRecordings, AllReadAndMoveSmoothly) {
  for (const char* name : {"grab", "pinch", "HandSplay-110fps", "confidence2", "test-paddle-rightwards"}) {
    const std::string path = recording_path(name + std::string(".json.lz"));
    SKIP_WITHOUT(path);
    const Trace trace = read_trace(path);
    EXPECT_EQ(trace.name, name);
    const TraceSpline motion(trace, 0);
    ASSERT_EQ(motion.presence().size(), 1u) << name;
    // Bone frames must not flip between frames: no phalanx spins at more than 60 rad/s (a flip at 115 Hz shows 360
    // rad/s).
    for (double t = 0; t < trace.t.back(); t += 1e-3) {
      for (int i = 0; i < phalanx_count; ++i)
        ASSERT_LT(motion.twist(i, t).w.norm(), 150) << name << " " << t << " " << i;
    }
  }
}

TEST(LeapRecordings, ATruncatedFileIsRejected) {
  const std::string path = recording_path("pinch.json.lz");
  SKIP_WITHOUT(path);
  const std::string text = read_text_file(path);
  for (const double share : {0.1, 0.5, 0.999}) {
    const std::string part = text.substr(0, static_cast<std::size_t>(share * static_cast<double>(text.size())));
    EXPECT_TRUE(contains(message_of([&] { return decompress_lz_string(part, "p.lz"); }), "without its end mark"));
  }
}

}  // namespace
}  // namespace handhold
