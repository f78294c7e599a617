// SPDX-License-Identifier: GPL-3.0-or-later
// Hands that are well formed and wrong. Each test changes one thing of a recording that no one doubts.
#include "cases/hand/trace_doubts.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "cases/hand/trace_glitches.hpp"
#include "cases/input/trace/trace_csv.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "tests/cases/input/sample_joints.hpp"
#include "tests/cases/input/trace_fixtures.hpp"
#include "tests/shared_data.hpp"

namespace handhold {
namespace {

using nlohmann::json;
using test::closing_hand;
using test::closing_recording;
using test::contains;
using test::message_of;
using test::with_joints;

/// What is said of a recording: its warnings, or the error.
std::string said(const std::string& text, const TraceReadOptions& options = {}, const std::string& name = "h.json") {
  const test::TemporaryFile file(name, text);
  std::string all;
  const std::string error = message_of([&] {
    for (const std::string& warning : read_trace(file.path(), options).warnings) all += warning + "\n";
    return 0;
  });
  return error == "accepted" ? all : "error: " + error;
}
std::string said(const json& recording, const TraceReadOptions& options = {}) {
  return said(recording.dump(), options);
}

json scaled_by(double factor) {
  return with_joints(closing_recording(), [factor](json& joint) {
    for (json& number : joint["position"]) number = factor * number.get<double>();
  });
}

TEST(TraceDoubts, AGoodHandIsNotDoubted) {
  for (const char* format : {"openxr", "webxr", "mano", "mano-model"})
    EXPECT_EQ(said(closing_recording(format)), "") << format;
  EXPECT_EQ(said(to_csv(closing_hand(60))), "");
  EXPECT_EQ(said(scaled_by(0.6)), "");  // a child
}

// No false alarm on what trackers really wrote: the eight public recordings of LeapJS and those of a headset.
TEST(TraceDoubts, RealRecordingsAreNotDoubted) {
  const std::filesystem::path folder = test::shared_data("traces");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  int files = 0;
  for (const char* kind : {"leapjs", "webxr"}) {
    for (const auto& entry : std::filesystem::directory_iterator(folder / kind)) {
      const Trace trace = read_trace(entry.path().string());
      EXPECT_TRUE(find_glitches(trace).empty()) << entry.path();
      // The emulator's right hand is, number for number, its left one: the only doubt, and a right one.
      const bool mislabelled = entry.path().filename() == "iwer_pinch_right.json";
      const std::vector<Doubt> found = doubts(trace);
      EXPECT_EQ(found.size(), mislabelled ? 1u : 0u) << entry.path() << (found.empty() ? "" : to_text(found[0]));
      ++files;
    }
  }
  EXPECT_GE(files, 10);
}

TEST(TraceDoubts, UnitsOfLength) {
  EXPECT_TRUE(contains(said(scaled_by(100)), "centimetres were read as metres")) << said(scaled_by(100));
  EXPECT_TRUE(contains(said(scaled_by(1000)), "error: "));
  EXPECT_TRUE(contains(said(scaled_by(1000)), "millimetres were read as metres"));
  EXPECT_TRUE(contains(said(scaled_by(1000)), "--scale 0.001"));
  EXPECT_TRUE(contains(said(scaled_by(0.001)), "--scale 1000"));
  EXPECT_TRUE(contains(said(scaled_by(2.5)), "times an adult's"));
  EXPECT_FALSE(contains(said(scaled_by(2.5)), "error: "));          // doubtful, but no mistaken unit
  EXPECT_EQ(said(scaled_by(1000), {false, false, 0.001}), "");      // the cure works
  EXPECT_FALSE(contains(said(scaled_by(100), {true}), "error: "));  // and so does trust
}

TEST(TraceDoubts, UnitsOfTime) {
  const auto in = [](double per_second) {
    json recording = closing_recording();
    for (json& frame : recording["frames"]) frame["t"] = per_second * frame["t"].get<double>();
    return recording;
  };
  EXPECT_TRUE(contains(said(in(1e3)), "milliseconds were read as seconds"));
  EXPECT_TRUE(contains(said(in(1e6)), "microseconds were read as seconds"));
  EXPECT_TRUE(contains(said(in(1e-3)), "--time-scale 1000"));
  EXPECT_TRUE(contains(said(in(30)), "2 frames a second"));
  EXPECT_FALSE(contains(said(in(30)), "error: "));
  EXPECT_EQ(said(in(1e3), {false, false, 1, 1e-3}), "");
  json stated = in(1e3);
  stated["time"] = "ms";
  EXPECT_EQ(said(stated), "");
}

TEST(TraceDoubts, SideAndHandedness) {
  json swapped = closing_recording();
  for (json& frame : swapped["frames"]) frame["hands"] = {{"left", frame["hands"]["right"]}};
  EXPECT_TRUE(contains(said(swapped), "fingers bend to the back of the hand")) << said(swapped);
  const auto mirrored = [](std::size_t axis) {
    return with_joints(closing_recording(),
                       [axis](json& joint) { joint["position"][axis] = -joint["position"][axis].get<double>(); });
  };
  json unity = mirrored(2);
  EXPECT_TRUE(contains(said(unity), "\"handedness\": \"left\""));
  unity["handedness"] = "left";
  EXPECT_EQ(said(unity), "");
  json y_down = mirrored(1);
  EXPECT_TRUE(contains(said(y_down), "\"up\": \"-y\""));
  y_down["handedness"] = "left";
  y_down["up"] = "-y";
  EXPECT_EQ(said(y_down), "");
  const test::TemporaryFile file("cured.json", y_down.dump()), good("good.json", closing_recording().dump());
  EXPECT_LT(
      (read_trace(file.path()).hands[0].samples[3].X_WP[4].p - read_trace(good.path()).hands[0].samples[3].X_WP[4].p)
          .norm(),
      1e-12);
}

TEST(TraceDoubts, ASideThatThePalmContradicts) {
  Trace trace = closing_hand(60);
  trace.hands[0].side = Side::left;
  ASSERT_EQ(doubts(trace).size(), 1u);
  EXPECT_TRUE(contains(doubts(trace)[0].evidence, "thumb is on the side of the other hand's"));
}

TEST(TraceDoubts, OrderOfJoints) {
  json recording = closing_recording("mano-model");
  recording["format"] = "mano";
  EXPECT_TRUE(contains(said(recording), "bones do not chain"));
  EXPECT_TRUE(contains(said(recording), "write \"format\": \"mano-model\""));
}

TEST(TraceDoubts, TheWristAtTheElbow) {
  const json recording = closing_recording("openxr");
  json elbow = recording;
  for (json& frame : elbow["frames"]) frame["hands"]["right"]["joints"][1]["position"][2] = -0.06;
  EXPECT_TRUE(contains(said(elbow), "from the knuckles, as far as the elbow"));
}

TEST(TraceDoubts, Radii) {
  const auto with_radius = [](double radius) {
    return with_joints(closing_recording(), [radius](json& joint) { joint["radius"] = radius; });
  };
  EXPECT_EQ(said(with_radius(0.009)), "");
  EXPECT_TRUE(contains(said(with_radius(0.02)), "every bone has a radius of 20 mm"));
  EXPECT_TRUE(contains(said(with_radius(8.5)), "error: "));
}

/// Orientations of joints as OpenXR wants them, -z along the bone and y to the back; here the finger's plane is x =
/// const.
json with_orientations(bool wxyz) {
  json recording = closing_recording();
  for (std::size_t i = 0; i < recording["frames"].size(); ++i) {
    json& joints = recording["frames"][i]["hands"]["right"]["joints"];
    const JointSet& set = joint_set("openxr");
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const int joint = set.entries[k].joint;
      Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
      if (joint >= 4 && joint < wrist_joint) {
        const double curl = double(i) / double(recording["frames"].size());
        const int from = joint % 4 == 3 ? joint - 1 : joint;
        const Eigen::Vector3d along = test::closing_joint(from + 1, curl) - test::closing_joint(from, curl);
        q = Eigen::Quaterniond::FromTwoVectors(-Eigen::Vector3d::UnitZ(), along);
      }
      joints[k]["orientation"] = wxyz ? json{q.w(), q.x(), q.y(), q.z()} : json{q.x(), q.y(), q.z(), q.w()};
    }
  }
  return recording;
}

TEST(TraceDoubts, OrderOfQuaternions) {
  EXPECT_EQ(said(with_orientations(false)), "");
  json mistaken = with_orientations(true);
  EXPECT_TRUE(contains(said(mistaken), "write \"quaternion\": \"wxyz\"")) << said(mistaken);
  mistaken["quaternion"] = "wxyz";
  EXPECT_EQ(said(mistaken), "");
}

TEST(TraceDoubts, AxesOfACsvThatDoNotFollowTheFingers) {
  Trace trace = closing_hand(60);
  for (HandSample& sample : trace.hands[0].samples) {
    for (Pose& X : sample.X_WP) X.R = Eigen::Quaterniond(X.R.z(), X.R.w(), X.R.x(), X.R.y()).normalized();
  }
  EXPECT_TRUE(contains(said(to_csv(trace)), "order of quaternions"));
}

TEST(TraceDoubts, OneFrameIsNoMotion) { EXPECT_TRUE(contains(said(closing_recording("mano", 1)), "one frame")); }

// A step of 155 mm within a frame, where the hand then stays: not a glitch, but not a hand either.
TEST(TraceDoubts, AJumpThatStays) {
  Trace trace = closing_hand(60);
  for (std::size_t i = 100; i < trace.t.size(); ++i) {
    for (Pose& X : trace.hands[0].samples[i].X_WP) X.p.y() += 0.155;
  }
  EXPECT_TRUE(find_glitches(trace).empty());
  EXPECT_TRUE(contains(said(to_csv(trace)), "frame 100 (1.667 s): jumps 155 mm in one frame"));
}

/// The whole hand, or the index finger's middle joint, elsewhere for `frames` frames.
Trace with_glitch(Trace trace, std::size_t frames, bool whole) {
  for (std::size_t i = 40; i < 40 + frames; ++i) {
    for (std::size_t k = 0; k < phalanx_count; ++k) {
      if (whole || k == 3 || k == 4) trace.hands[0].samples[i].X_WP[k].p.y() += whole ? 1 : 0.15;
    }
  }
  return trace;
}

TEST(TraceGlitches, AreFoundAndBridged) {
  for (const double rate : {17.0, 60.0, 110.0}) {
    const Trace good = closing_hand(rate);
    ASSERT_TRUE(find_glitches(good).empty()) << rate;
    for (const bool whole : {true, false}) {
      for (const std::size_t frames : {1u, 2u, 3u}) {
        if (good.t.size() < 60 || (rate < 60 && !whole)) continue;
        Trace trace = with_glitch(good, frames, whole);
        const std::vector<Glitch> found = find_glitches(trace);
        ASSERT_EQ(found.size(), 1u) << rate << ' ' << whole << ' ' << frames;
        EXPECT_EQ(found[0].first, 40u);
        EXPECT_EQ(found[0].count, frames);
        EXPECT_EQ(found[0].phalanges.count(), whole ? 16u : 2u);
        bridge(trace, found);
        // The wrist's peak acceleration is 5.8 * 0.3 m/s² (minimum jerk); fingertips of 0.1 m that turn by 4 rad in a
        // second add as much again, and the line over the gap T is off by a T² / 8.
        const double gap = double(frames + 1) / rate;
        for (std::size_t k = 0; k < phalanx_count; ++k)
          EXPECT_LT((trace.hands[0].samples[40].X_WP[k].p - good.hands[0].samples[40].X_WP[k].p).norm(),
                    gap * gap / 8 * 20);
        EXPECT_TRUE(find_glitches(trace).empty());
      }
    }
  }
}

TEST(TraceGlitches, WarnOrAreRepaired) {
  const std::string csv = to_csv(with_glitch(closing_hand(60), 1, false));
  EXPECT_TRUE(
      contains(said(csv), "right hand, frame 40 (0.667 s): index_proximal, index_intermediate jumps 150 mm aside"));
  EXPECT_TRUE(contains(said(csv), "(bridge it with --repair)"));
  EXPECT_TRUE(contains(said(csv, {false, true}), ": bridged"));
  // The whole hand one metre aside is one glitch and no jump there and back.
  const std::string whole = said(to_csv(with_glitch(closing_hand(60), 1, true)));
  EXPECT_TRUE(contains(whole, "the hand jumps 1000 mm aside for 1 frame")) << whole;
  EXPECT_FALSE(contains(whole, "m/s"));
}

// White noise of any size must not alarm: no excursion of 80 000 comes near eight times the median.
TEST(TraceGlitches, NoiseDoesNotAlarm) {
  const Trace still = closing_hand(60);
  for (const double size : {1e-3, 1e-2}) {
    std::uint64_t state = 1;
    const auto uniform = [&state] {
      state = state * 6364136223846793005u + 1442695040888963407u;
      return double(state >> 11) * 0x1p-53;
    };
    for (int repeat = 0; repeat < 20; ++repeat) {
      Trace trace = still;
      for (HandSample& sample : trace.hands[0].samples) {
        for (Pose& X : sample.X_WP) {
          for (int axis = 0; axis < 3; ++axis)  // twelve uniform deviates make a Gaussian one
            for (int k = 0; k < 12; ++k) X.p[axis] += size * (uniform() - 0.5);
        }
      }
      EXPECT_TRUE(find_glitches(trace).empty()) << size;
    }
  }
}

}  // namespace
}  // namespace handhold
