// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/joints_reader.hpp"

#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cases/input/text_file.hpp"
#include "cases/input/trace/joint_sets.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "tests/cases/input/trace_fixtures.hpp"
#include "tests/shared_data.hpp"

namespace handhold {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using test::contains;
using test::message_of;
using test::starts_with;

/// Joint positions of a flat right hand, palm down, fingers forward, as OpenXR sees it: y up, -z forward, so the thumb
/// of a right hand is at -x. Fingers 20 mm apart, knuckles 90 mm before the wrist, bones of 40, 25 and 20 mm.
Vector3d flat_hand(int joint) {
  if (joint == wrist_joint || joint == palm_joint) return {0, 1, joint == palm_joint ? -0.05 : 0};
  const int finger = joint / 4, n = joint % 4;
  const double ahead[4] = {0, 0.040, 0.065, 0.085};
  if (finger == 0) return {-0.03 - 0.7 * ahead[n], 1, -0.03 - 0.7 * ahead[n]};
  return {-0.03 + 0.02 * (finger - 1), 1, -0.09 - ahead[n]};
}

json joint_of_place(const JointSet& set, std::size_t place) {
  const int joint = set.entries[place].joint;
  const Vector3d p = joint == unused_joint ? Vector3d(0, 1, -0.02) : flat_hand(joint);
  json value{{"position", {p.x(), p.y(), p.z()}}, {"radius", 0.008}};
  if (set.minus_z_forward) value["orientation"] = {0, 0, 0, 1};
  return value;
}

json flat_recording(const std::string& format, const std::vector<double>& times, bool named = false) {
  const JointSet& set = joint_set(format);
  json joints = json::array();
  for (std::size_t i = 0; i < set.entries.size(); ++i) {
    joints.push_back(joint_of_place(set, i));
    if (named) joints.back()["name"] = std::string(set.entries[i].name);
  }
  json frames = json::array();
  for (const double t : times)
    frames.push_back({{"t", t}, {"hands", {{"right", {{"joints", joints}}}, {"left", nullptr}}}});
  return {{"format", format}, {"unit", "m"}, {"up", "y"}, {"frames", frames}};
}

Trace read(const json& recording) { return read_joints(recording.dump(), "x.json"); }

// y up to z up is (x, y, z) -> (x, -z, y): forward (-z) becomes +y. The index proximal bone goes from (-30, 90) mm
// forward by 40 mm at a height of 1 m; its back looks up.
TEST(JointsReader, EveryFormatGivesTheSameHand) {
  for (const char* format : {"openxr", "webxr", "mano"}) {
    const Trace trace = read(flat_recording(format, {5, 5.01}));
    ASSERT_EQ(trace.hands.size(), 1u) << format;
    EXPECT_EQ(trace.t[0], 0);  // starts at zero
    EXPECT_NEAR(trace.t[1], 0.01, 1e-12);
    const Pose& X = trace.hands[0].samples[0].X_WP[3];
    EXPECT_LT((X.p - Vector3d(-0.03, 0.11, 1)).norm(), 1e-12) << format;
    EXPECT_LT((X.R * Vector3d::UnitZ() - Vector3d::UnitY()).norm(), 1e-12) << format;
    EXPECT_LT((X.R * Vector3d::UnitY() - Vector3d::UnitZ()).norm(), 1e-12) << format;
    EXPECT_LT((trace.hands[0].samples[0].X_WP[palm].R * Vector3d::UnitY() - Vector3d::UnitZ()).norm(), 1e-12) << format;
    EXPECT_NEAR(trace.hands[0].model.capsules[3].half_length, 0.02, 1e-12);
    EXPECT_NEAR(trace.hands[0].model.capsules[3].radius, 0.008, 1e-12);
  }
}

TEST(JointsReader, PalmReachesFromWristToKnuckles) {
  const Trace trace = read(flat_recording("openxr", {0, 1}));
  const Vector3d& half = trace.hands[0].model.palm_box.half_extents;
  EXPECT_NEAR(half.z(), 0.045, 1e-12);         // 90 mm
  EXPECT_NEAR(half.x(), 0.03 + 0.008, 1e-12);  // knuckles 60 mm apart and the radii
  EXPECT_LT((trace.hands[0].samples[0].X_WP[palm].p - Vector3d(0, 0.045, 1)).norm(), 1e-12);
}

TEST(JointsReader, NamedJointsMayComeInAnyOrder) {
  json named = flat_recording("webxr", {0, 1}, true);
  for (json& frame : named["frames"]) {
    json& joints = frame["hands"]["right"]["joints"];
    std::reverse(joints.begin(), joints.end());
  }
  const Trace a = read(named), b = read(flat_recording("webxr", {0, 1}));
  for (std::size_t i = 0; i < phalanx_count; ++i) {
    EXPECT_EQ(a.hands[0].samples[1].X_WP[i].p, b.hands[0].samples[1].X_WP[i].p);
  }
}

TEST(JointsReader, MillimetresAndZUp) {
  json recording = flat_recording("mano", {0, 1});
  recording["unit"] = "mm";
  recording["up"] = "z";
  for (json& frame : recording["frames"]) {
    for (json& joint : frame["hands"]["right"]["joints"]) {
      const std::vector<double> p = joint["position"];
      joint["position"] = {1000 * p[0], -1000 * p[2], 1000 * p[1]};
      joint["radius"] = 8;
    }
  }
  const Trace a = read(recording), b = read(flat_recording("mano", {0, 1}));
  EXPECT_LT((a.hands[0].samples[0].X_WP[8].p - b.hands[0].samples[0].X_WP[8].p).norm(), 1e-12);
  EXPECT_NEAR(a.hands[0].model.capsules[8].radius, 0.008, 1e-12);
  EXPECT_EQ(a.source_frame, "mm, z up, right-handed");
}

TEST(JointsReader, NullIsUntracked) {
  json recording = flat_recording("openxr", {0, 1, 2, 3});
  recording["frames"][1]["hands"]["right"] = nullptr;
  recording["frames"][2]["hands"]["right"]["joints"][9] = nullptr;
  recording["frames"][3]["hands"]["right"]["joints"][9]["position"][1] = nullptr;  // how JSON writes NaN
  const Trace trace = read(recording);
  EXPECT_TRUE(trace.hands[0].samples[0].tracked);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_FALSE(trace.hands[0].samples[i].tracked) << i;
  ASSERT_EQ(trace.warnings.size(), 1u);
  EXPECT_TRUE(contains(trace.warnings[0], "2 of 4 frames"));
}

TEST(JointsReader, RepeatedStampsAreDroppedTheLaterOne) {
  json recording = flat_recording("openxr", {0, 0.5, 0.5, 1});
  recording["frames"][2]["hands"]["right"] = nullptr;
  const Trace trace = read(recording);
  EXPECT_EQ(trace.t.size(), 3u);
  EXPECT_TRUE(trace.hands[0].samples[1].tracked);
  ASSERT_EQ(trace.warnings.size(), 1u);
  EXPECT_TRUE(starts_with(trace.warnings[0], "1 frames repeat the time stamp"));
}

TEST(JointsReader, BadInput) {
  const auto message = [](const json& recording) { return message_of([&] { return read(recording); }); };
  const json good = flat_recording("openxr", {0, 1, 2}, true);
  EXPECT_EQ(message(good), "accepted");

  json bad = good;
  bad["frames"][2]["t"] = 0.5;
  EXPECT_TRUE(starts_with(message(bad), "x.json, frame 2: the time stamp 0.500000 s lies before 1.000000 s"));
  bad["frames"][2]["t"] = nullptr;
  EXPECT_TRUE(starts_with(message(bad), "x.json, frame 2: the time stamp is not a number"));

  bad = good;
  bad["frames"][1]["hands"]["right"]["joints"][3]["name"] = "thumb_metatarsal";
  EXPECT_TRUE(
      starts_with(message(bad), "x.json, frame 1, right hand: joint \"thumb_metatarsal\" is unknown in openxr"));
  EXPECT_TRUE(contains(message(bad), "thumb_proximal, thumb_distal"));

  bad = flat_recording("openxr", {0, 1});
  bad["frames"][1]["hands"]["right"]["joints"].erase(4);
  EXPECT_TRUE(contains(message(bad), "25 joints, but openxr has 26"));

  bad = good;
  bad["frames"][0]["hands"]["middle"] = bad["frames"][0]["hands"]["right"];
  EXPECT_TRUE(contains(message(bad), "hand \"middle\" is unknown"));

  bad = good;
  for (json& frame : bad["frames"]) frame["hands"]["right"] = nullptr;
  EXPECT_TRUE(contains(message(bad), "no frame with a whole hand"));

  bad = good;
  bad["frames"] = json::array();
  EXPECT_TRUE(contains(message(bad), "there are no frames"));
  bad = good;
  bad["format"] = "kinect";
  EXPECT_TRUE(starts_with(message(bad), "x.json: joint set \"kinect\""));
  bad = good;
  bad["unit"] = "ft";
  EXPECT_TRUE(starts_with(message(bad), "x.json: unit \"ft\""));
  bad = good;
  bad["up"] = 3;  // not silently the default: the hand would lie on its side
  EXPECT_TRUE(starts_with(message(bad), "x.json: \"up\" is no text"));
}

// Members of every wrong kind: an InputError or a lost hand, never another exception.
TEST(JointsReader, WrongKindsOfMembersNeverEscape) {
  const json good = flat_recording("openxr", {0, 1}, true);
  const json flat = good.flatten();
  for (const json& junk : {json(nullptr), json(7), json("text"), json::array(), json::object(), json(true)}) {
    for (const auto& [pointer, value] : flat.items()) {
      json bad = good;
      bad[json::json_pointer(pointer)] = junk;
      EXPECT_NO_THROW((void)message_of([&] { return read(bad); })) << pointer;
    }
    for (const char* pointer : {"/frames", "/frames/0", "/frames/0/hands", "/frames/0/hands/right",
                                "/frames/0/hands/right/joints", "/frames/0/hands/right/joints/0"}) {
      json bad = good;
      bad[json::json_pointer(pointer)] = junk;
      EXPECT_NO_THROW((void)message_of([&] { return read(bad); })) << pointer;
    }
  }
}

TEST(ReadTrace, DecidesByContent) {
  const test::TemporaryFile file("joints.txt", "\xEF\xBB\xBF " + flat_recording("webxr", {0, 1}).dump(1));
  EXPECT_EQ(read_trace(file.path()).hands.size(), 1u);
}

// A real recording packed by LZString, without its telling name.
TEST(ReadTrace, KnowsPackedTextByItsContent) {
  const std::string path = test::shared_data("traces/leapjs/grab.json.lz");
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const test::TemporaryFile file("packed.txt", read_text_file(path));
  EXPECT_EQ(read_trace(file.path()).t.size(), 374u);  // frames of grab.json
}

TEST(ReadTrace, AnEndlessFileIsRefused) {
  EXPECT_TRUE(contains(message_of([] { return read_trace("/dev/zero"); }), "is a device or a pipe"));
}

TEST(ReadTrace, RejectsWhatItCannotRead) {
  const auto message = [](const std::string& name, const std::string& text) {
    const test::TemporaryFile file(name, text);
    return message_of([&] { return read_trace(file.path()); });
  };
  EXPECT_TRUE(contains(message("empty.csv", " \n"), "the file is empty"));
  EXPECT_TRUE(contains(message("a.bvh", "HIERARCHY"), "this format is unknown"));
  EXPECT_TRUE(contains(message("a.json", "{\"frames\": [\n1,\n"), ".json:3, byte"));
  EXPECT_TRUE(contains(message("a.json", "{\"frames\": [1e999]}"), "beyond 1e308"));
  EXPECT_TRUE(contains(message("a.lz", "BYUw!"), "byte 4: this character is not base64"));
  EXPECT_TRUE(contains(message("a.lz", "BYUwNmD2Q==="), "this is not JSON"));  // "hello"
  EXPECT_TRUE(contains(message_of([] { return read_trace("/nowhere/a.csv"); }), "no such file"));
  EXPECT_TRUE(contains(message_of([] { return read_trace("/"); }), "is a folder"));
}

}  // namespace
}  // namespace handhold
