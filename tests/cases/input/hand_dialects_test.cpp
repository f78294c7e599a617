// SPDX-License-Identifier: GPL-3.0-or-later
// The ways in which others write the same hand: each must give the poses of the plain one, or say what to do.
#include <algorithm>

#include <gtest/gtest.h>
#include <zlib.h>

#include "cases/input/text_file.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "tests/cases/input/sample_joints.hpp"
#include "tests/cases/input/trace_fixtures.hpp"

namespace handhold {
namespace {

using nlohmann::json;
using test::closing_recording;
using test::contains;
using test::message_of;
using test::position_of;
using test::with_joints;

Trace read(const std::string& text, const std::string& name = "h.json") {
  const test::TemporaryFile file(name, text);
  return read_trace(file.path());
}
Trace read(const json& recording) { return read(recording.dump()); }
std::string message(const std::string& text) {
  return message_of([&] { return read(text); });
}
std::string message(const json& recording) { return message(recording.dump()); }
std::string message(const char* text) { return message(std::string(text)); }

/// The same bones, within what rounding to `tolerance` leaves.
void expect_same(const Trace& a, const Trace& b, double tolerance = 1e-9) {
  ASSERT_EQ(a.t.size(), b.t.size());
  ASSERT_EQ(a.hands.size(), 1u);
  EXPECT_EQ(a.hands[0].side, b.hands[0].side);
  for (std::size_t i = 0; i < a.t.size(); ++i) {
    EXPECT_NEAR(a.t[i], b.t[i], 1e-4);
    for (std::size_t k = 0; k < palm; ++k)
      EXPECT_LT((a.hands[0].samples[i].X_WP[k].p - b.hands[0].samples[i].X_WP[k].p).norm(), tolerance) << i << ' ' << k;
  }
}

TEST(HandDialects, ListsOfFramesAndLines) {
  const json plain = closing_recording();
  const Trace good = read(plain);
  expect_same(read(plain["frames"]), good);
  std::string lines;
  for (const json& frame : plain["frames"]) lines += frame.dump() + "\n";
  expect_same(read(lines), good);
  EXPECT_TRUE(contains(read(lines).warnings.at(0), "26 joints a hand, taken as those of openxr"));
  expect_same(read("{\"format\": \"openxr\"}\r\n" + lines), good);
  EXPECT_TRUE(read("{\"format\": \"openxr\"}\n" + lines).warnings.empty());
}

TEST(HandDialects, NumbersAndMembers) {
  const json plain = closing_recording("mano");
  const Trace good = read(plain);
  const auto p = [](const json& joint, int i) { return joint["position"][std::size_t(i)]; };
  expect_same(read(with_joints(plain, [&](json& j) { j = {{"x", p(j, 0)}, {"y", p(j, 1)}, {"z", p(j, 2)}}; })), good);
  expect_same(read(with_joints(plain, [&](json& j) { j = {p(j, 0), p(j, 1), p(j, 2)}; })), good);
  expect_same(read(with_joints(plain, [&](json& j) { j = {p(j, 0), p(j, 1), p(j, 2), 0, 0, 0, 0}; })), good);
  expect_same(read(with_joints(plain,
                               [&](json& j) {
                                 j = {{"pos", {{"x", p(j, 0)}, {"y", p(j, 1)}, {"z", p(j, 2)}}},
                                      {"rotation", {{"x", 0}, {"y", 0}, {"z", 0}, {"w", 0}}}};
                               })),
              good);
  for (const bool by_columns : {true, false}) {
    json row = json::array(), matrices = plain;
    for (json& frame : matrices["frames"]) {
      row = json::array();
      for (const json& j : frame["hands"]["right"]["joints"]) {
        const std::vector<json> columns{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, p(j, 0), p(j, 1), p(j, 2), 1};
        for (std::size_t i = 0; i < 16; ++i) row.push_back(columns[by_columns ? i : 4 * (i % 4) + i / 4]);
      }
      frame["hands"]["right"]["joints"] = row;
    }
    matrices["format"] = "mano";
    expect_same(read(matrices), good);
  }
}

TEST(HandDialects, NamesOfOthers) {
  const Trace good = read(closing_recording());
  const auto renamed = [](const std::string& format, const auto& name_of) {
    json recording = closing_recording(format, 12, true);
    for (json& frame : recording["frames"]) {
      for (json& joint : frame["hands"]["right"]["joints"]) joint["name"] = name_of(joint["name"].get<std::string>());
      std::reverse(frame["hands"]["right"]["joints"].begin(), frame["hands"]["right"]["joints"].end());
    }
    return recording;
  };
  const auto unity = [](const std::string& name) {
    std::string out;
    for (const std::string& word : words_of(name)) out += char(std::toupper(word[0])) + word.substr(1);
    return out;
  };
  const auto upper = [](std::string name) {
    for (char& c : name) c = char(std::toupper(c));
    return name;
  };
  const auto enumerator = [&](const std::string& name) { return "XR_HAND_JOINT_" + upper(name) + "_EXT"; };
  expect_same(read(renamed("openxr", unity)), good);
  expect_same(read(renamed("openxr", enumerator)), good);
  json unnamed = renamed("webxr", unity);
  unnamed.erase("format");
  expect_same(read(unnamed), good);
  EXPECT_TRUE(read(unnamed).warnings.empty());  // names tell the format

  json by_name = closing_recording("openxr", 12, true);
  for (json& frame : by_name["frames"]) {
    json joints = json::object();
    for (const json& joint : frame["hands"]["right"]["joints"])
      joints[joint["name"].get<std::string>()] = {{"position", joint["position"]}};
    frame["hands"]["right"]["joints"] = joints;
  }
  expect_same(read(by_name), good);

  json capital = closing_recording();
  capital["format"] = "OpenXR";
  expect_same(read(capital), good);
}

// MediaPipe: x right, y down, z away from the camera, names like INDEX_FINGER_MCP, hands in a list.
TEST(HandDialects, MediaPipe) {
  json recording = closing_recording("mediapipe", 12, true);
  recording = with_joints(recording, [](json& joint) {
    const Eigen::Vector3d p = Eigen::Vector3d(joint["position"][0], joint["position"][1], joint["position"][2]);
    joint["position"] = position_of({p.x(), -p.y(), -p.z()});
    std::string name = joint["name"];
    for (char& c : name) c = char(std::toupper(c));
    if (const auto cut = name.find("LITTLE"); cut == 0) name = "PINKY" + name.substr(6);
    joint["name"] = name;
  });
  for (json& frame : recording["frames"]) {
    json hand = frame["hands"]["right"];
    hand = {{"handedness", "Right"}, {"score", 0.9}, {"landmarks", hand["joints"]}};
    frame["hands"] = json::array({hand});
  }
  expect_same(read(recording), read(closing_recording("mano")));
  EXPECT_EQ(read(recording).hands[0].samples[0].confidence, 0.9);
  recording["frames"][0]["hands"][0].erase("handedness");
  EXPECT_TRUE(contains(message(recording), "frame 0: a hand does not say which it is (add \"handedness\""));
}

TEST(HandDialects, WebXrEmulator) {
  const Eigen::Vector3d p_WT(0.1, 1.2, -0.3);
  const Eigen::Quaterniond R_WT(0.8, 0, 0.6, 0);  // the joints are in the frame of the target ray
  json names = json::array(), frames = json::array();
  for (const JointSet::Entry& entry : joint_set("webxr").entries) names.push_back(std::string(entry.name));
  for (int i = 0; i < 12; ++i) {
    json joints = json::array();
    for (const JointSet::Entry& entry : joint_set("webxr").entries) {
      const Eigen::Vector3d p = R_WT.conjugate() * (test::closing_joint(entry.joint, i / 12.0) - p_WT);
      for (const double number : {p.x(), p.y(), p.z(), 0., -0.6, 0., 0.8, 0.009}) joints.push_back(number);
    }
    json input{0, p_WT.x(), p_WT.y(), p_WT.z(), 0, 0.6, 0, 0.8, {0, 0, 0, 0, 0, 0, 1}, joints};  // grip, then hand
    frames.push_back({5000 + 1000.0 * i / 60, 0, 1.6, 0, 0, 0, 0, 1, input});
  }
  const json schema{{0, {{"handedness", "right"}, {"hasGrip", true}, {"hasHand", true}, {"jointSequence", names}}}};
  const Trace trace = read(json{{"schema", schema}, {"frames", frames}});
  expect_same(trace, read(closing_recording("webxr")));
  EXPECT_TRUE(contains(trace.warnings.at(0), "rounds positions to 1 mm"));
}

TEST(HandDialects, LeapC) {
  json frames = json::array(), leap_js = json::array();
  const auto p = [](int joint, int i) -> json {
    return position_of(Eigen::Vector3d(1000 * test::closing_joint(joint, i / 12.0)));
  };
  for (int i = 0; i < 12; ++i) {
    json digits = json::array(), pointables = json::array();
    for (int finger = 0; finger < 5; ++finger) {
      json bones = json::array({{{"prev_joint", p(palm_joint, i)}, {"next_joint", p(4 * finger, i)}, {"width", 17}}});
      for (int bone = 0; bone < 3; ++bone)
        bones.push_back(
            {{"prev_joint", p(4 * finger + bone, i)}, {"next_joint", p(4 * finger + bone + 1, i)}, {"width", 17}});
      digits.push_back({{"finger_id", finger}, {"bones", bones}});
      pointables.push_back({{"handId", 0},
                            {"type", finger},
                            {"width", 17},
                            {"mcpPosition", p(4 * finger, i)},
                            {"pipPosition", p(4 * finger + 1, i)},
                            {"dipPosition", p(4 * finger + 2, i)},
                            {"tipPosition", p(4 * finger + 3, i)}});
    }
    const json center{{"position", p(palm_joint, i)}, {"normal", {0, -1, 0}}, {"direction", {0, 0, -1}}};
    frames.push_back({{"tracking_frame_id", i},
                      {"timestamp", 1e6 * i / 60},
                      {"nHands", 1},
                      {"hands", {{{"type", "right"}, {"palm", center}, {"digits", digits}}}}});
    leap_js.push_back({{"timestamp", 1e6 * i / 60},
                       {"hands",
                        {{{"id", 0},
                          {"type", "right"},
                          {"palmPosition", p(palm_joint, i)},
                          {"palmNormal", {0, -1, 0}},
                          {"direction", {0, 0, -1}}}}},
                       {"pointables", pointables}});
  }
  expect_same(read(json{{"frames", frames}}), read(json{{"frames", leap_js}}));
  for (json& frame : leap_js) {
    for (json& pointable : frame["pointables"])
      for (const char* bone : {"mcpPosition", "pipPosition", "dipPosition"}) pointable.erase(bone);
  }
  EXPECT_TRUE(contains(message(json{{"frames", leap_js}}), "tips but no joints, as before version 2"));
}

TEST(HandDialects, WideCsv) {
  const json plain = closing_recording("openxr", 12, true);
  for (const bool sided : {true, false}) {
    std::string csv = "time";
    for (const JointSet::Entry& entry : joint_set("openxr").entries)
      for (const char* axis : {"_x", "_y", "_z"})
        csv += "," + std::string(sided ? "right_" : "") + std::string(entry.name) + axis;
    for (const json& frame : plain["frames"]) {
      csv += "\r\n" + frame["t"].dump();
      for (const json& joint : frame["hands"]["right"]["joints"])
        for (const json& number : joint["position"]) csv += "," + number.dump();
    }
    const Trace trace = read(csv, "h.csv");
    expect_same(trace, read(plain));
    EXPECT_EQ(trace.warnings.size(), sided ? 0u : 1u);
  }
  EXPECT_TRUE(contains(message("time,wrist_x,wrist_y,wrist_z,mood\n0,1,2,3,4\n"), ":1: column \"mood\" is unknown"));
  EXPECT_TRUE(contains(message("time,wrist_x,wrist_y,wrist_z\n0,1,2\n"), ":2: 3 fields for 4 columns"));
  EXPECT_TRUE(contains(message("time,wrist_x,wrist_y,wrist_z\n0,1,2,a\n"), ":2: \"a\" is not a number"));
}

std::string utf16(const std::string& ascii, bool big_endian, bool mark) {
  std::string out = !mark ? "" : big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : ascii) out += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return out;
}

std::string gzipped(const std::string& text) {
  std::string out(compressBound(uLong(text.size())) + 64, '\0');
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 31, 9, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = uInt(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = uInt(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

TEST(HandDialects, EncodingsAndGzip) {
  const std::string text = closing_recording().dump();
  const Trace good = read(text);
  for (const bool big : {true, false}) {
    for (const bool mark : {true, false}) expect_same(read(utf16(text, big, mark)), good);
  }
  expect_same(read("\xEF\xBB\xBF" + text), good);
  const std::string packed = gzipped(text);
  expect_same(read(packed, "h.json.gz"), good);
  EXPECT_TRUE(contains(message(packed.substr(0, packed.size() / 2)), "gzip file is damaged or cut off"));
  EXPECT_TRUE(
      contains(message(utf16(text.substr(0, text.size() / 2), false, true)), "the file was cut off, copy it whole"));
}

TEST(HandDialects, NotANumberIsALostJoint) {
  std::string text = closing_recording().dump();
  for (const char* literal : {"NaN", "-Infinity", "null"}) {
    json recording = closing_recording();
    recording["frames"][3]["hands"]["right"]["joints"][9]["position"][1] = "HERE";
    std::string broken = recording.dump();
    broken.replace(broken.find("\"HERE\""), 6, literal);
    const Trace trace = read(broken);
    EXPECT_FALSE(trace.hands[0].samples[3].tracked) << literal;
    EXPECT_TRUE(trace.hands[0].samples[4].tracked) << literal;
    EXPECT_TRUE(contains(trace.warnings.at(0), "1 of 12 frames have missing or degenerate joints")) << literal;
  }
}

TEST(HandKeys, UnknownAndMissingOnesAreNamed) {
  json bad = closing_recording();
  bad["units"] = "cm";
  EXPECT_TRUE(contains(message(bad), "\"units\" is unknown (did you mean \"unit\"?)"));
  bad = closing_recording();
  bad["frames"][2]["timestamp"] = bad["frames"][2]["t"];
  bad["frames"][2].erase("t");
  EXPECT_TRUE(contains(message(bad), "frame 2: \"timestamp\" is unknown (did you mean \"t\"?)"));
  bad["frames"][2].erase("timestamp");
  EXPECT_TRUE(contains(message(bad), "frame 2: \"t\" is missing (add"));
  bad["frames"][2]["t"] = "0.03";
  EXPECT_TRUE(contains(message(bad), "frame 2: \"t\" is text, \"0.03\", and no number (remove the quotes)"));
  bad = closing_recording();
  bad["frames"][1]["hands"]["right"]["joints"][4]["radios"] = 0.01;
  EXPECT_TRUE(contains(message(bad), "frame 1, right hand, joint 4: \"radios\" is unknown (did you mean \"radius\"?)"));
  for (const json& confidence : {json(95), json("high"), json(-0.1)}) {
    bad = closing_recording();
    bad["frames"][0]["hands"]["right"]["confidence"] = confidence;
    EXPECT_TRUE(contains(message(bad), "must be a number from 0 to 1")) << confidence;
  }
  bad = closing_recording("webxr");
  bad["format"] = "openxr";
  EXPECT_TRUE(contains(message(bad), "25 joints, but openxr has 26 (webxr has 25: write \"format\": \"webxr\""));
}

// Nesting of every kind and depth is one line, never a crash.
TEST(HostileText, DepthIsBounded) {
  for (const int levels : {65, 1000, 200'000}) {
    for (const char* open : {"[", "{\"a\":"}) {
      std::string text = R"({"frames":[{"timestamp":1,"x":)";
      for (int i = 0; i < levels; ++i) text += open;
      EXPECT_TRUE(contains(message(text), ":1, byte ")) << levels;
      EXPECT_TRUE(contains(message(text), "more than 64 levels")) << levels;
    }
  }
}

TEST(HostileText, NamesAreCleaned) {
  const Trace trace = read("# handhold trace 1\n# name a\x1b[31m\xE2\x80\xAE\n0,0,right,lost,,,,,,,,0\n", "n.csv");
  EXPECT_EQ(trace.name, "a\xEF\xBF\xBD[31m\xEF\xBF\xBD");
  EXPECT_EQ(stem_of("x/a\x1b.json"), "a\xEF\xBF\xBD");
}

}  // namespace
}  // namespace handhold
