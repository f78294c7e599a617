// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/trace_csv.hpp"

#include <filesystem>

#include <gtest/gtest.h>

#include "cases/hand/sensor_faults.hpp"
#include "cases/input/text_file.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "tests/cases/input/trace_fixtures.hpp"

namespace handhold {
namespace {

using test::closing_hand;
using test::contains;
using test::message_of;
using test::starts_with;

/// Two hands, noise and losses: nothing is a round number.
Trace awkward() {
  SensorFaults faults;
  faults.position_noise = 1e-4;
  faults.rotation_noise = 1e-3;
  faults.gaps = {{0.31, 0.42}};
  Trace trace = with_faults(closing_hand(37), faults, 5);
  trace.hands.push_back(with_faults(closing_hand(37, Side::left), faults, 6).hands[0]);
  trace.name = "two words";
  return trace;
}

// The shortest decimal that reads back to the same double: every number returns to the last bit.
TEST(TraceCsv, RoundTripIsExact) {
  const Trace trace = awkward();
  const Trace back = read_trace_csv(to_csv(trace), "a.csv");
  EXPECT_EQ(back.name, "two words");
  EXPECT_EQ(back.t, trace.t);
  ASSERT_EQ(back.hands.size(), 2u);
  for (std::size_t h = 0; h < 2; ++h) {
    EXPECT_EQ(back.hands[h].side, trace.hands[h].side);
    EXPECT_EQ(back.hands[h].model.palm_box.half_extents, trace.hands[h].model.palm_box.half_extents);
    EXPECT_EQ(back.hands[h].model.capsules[5].half_length, trace.hands[h].model.capsules[5].half_length);
    for (std::size_t i = 0; i < trace.t.size(); ++i) {
      const HandSample &a = trace.hands[h].samples[i], &b = back.hands[h].samples[i];
      ASSERT_EQ(a.tracked, b.tracked);
      ASSERT_EQ(a.confidence, b.confidence);
      for (std::size_t k = 0; a.tracked && k < phalanx_count; ++k) {
        ASSERT_EQ(a.X_WP[k].p, b.X_WP[k].p);
        ASSERT_EQ(a.X_WP[k].R.coeffs(), b.X_WP[k].R.coeffs());
      }
    }
  }
}

TEST(TraceCsv, WritesAFileThatReadTraceReads) {
  const test::TemporaryFile file("trace.csv", "");
  write_trace_csv(awkward(), file.path());
  EXPECT_EQ(read_trace(file.path()).t.size(), awkward().t.size());
  EXPECT_TRUE(
      contains(message_of([] { return write_trace_csv(awkward(), "/nowhere/a.csv"), 0; }), "cannot be written"));
}

TEST(TraceCsv, AFullDiskLeavesTheOldFile) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  const test::TemporaryFile file("kept.csv", "old");
  std::filesystem::create_symlink("/dev/full", file.path() + ".part");
  EXPECT_TRUE(contains(message_of([&] { return write_trace_csv(awkward(), file.path()), 0; }), "cannot be written"));
  EXPECT_EQ(read_text_file(file.path()), "old");
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::symlink_status(file.path() + ".part")));
}

/// 16 lines of one hand at `t`, every phalanx at the same place and turn.
std::string hand_lines(const std::string& t, const std::string& pose = "1,2,3,1,0,0,0") {
  std::string lines;
  for (int i = 0; i < phalanx_count; ++i) {
    lines += t + ",0,right," + std::string(phalanx_name(i)) + "," + pose + ",0.5\n";
  }
  return lines;
}

Trace read(const std::string& header, const std::string& lines) {
  return read_trace_csv("# handhold trace 1\n" + header + lines, "a.csv");
}

TEST(TraceCsv, ConvertsUnitsAndAxes) {
  // y up: (x, y, z) -> (x, -z, y); mm; ms.
  const Trace y_up = read("# unit mm\n# up y\n# time ms\n", hand_lines("0") + hand_lines("20"));
  EXPECT_EQ(y_up.t[1], 0.02);
  EXPECT_EQ(y_up.hands[0].samples[0].X_WP[4].p, Eigen::Vector3d(0.001, -0.003, 0.002));
  EXPECT_EQ(y_up.source_frame, "mm, y up, right-handed");
  // x up: (x, y, z) -> (y, z, x).
  EXPECT_EQ(read("# up x\n", hand_lines("0")).hands[0].samples[0].X_WP[4].p, Eigen::Vector3d(2, 3, 1));
}

// A turn takes the file's vectors along: R' = T R with the turn T of the axes, checked on the phalanx's own axes.
TEST(TraceCsv, ConvertsRotations) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(0.5, 0.1, -0.7, 0.5).normalized();
  const std::string pose = "0,0,0," + std::to_string(q.w()) + "," + std::to_string(q.x()) + "," +
                           std::to_string(q.y()) + "," + std::to_string(q.z());
  const auto X = [&](const std::string& header) {
    return read(header, hand_lines("0", pose)).hands[0].samples[0].X_WP[3];
  };
  const Eigen::Vector3d z = q * Eigen::Vector3d::UnitZ(), y = q * Eigen::Vector3d::UnitY();
  constexpr double six_digits = 2e-6;  // std::to_string
  const auto expect_axes = [&](const Pose& pose_W, const auto& turn) {
    EXPECT_LT((pose_W.R * Eigen::Vector3d::UnitZ() - turn(z)).norm(), six_digits);
    EXPECT_LT((pose_W.R * Eigen::Vector3d::UnitY() - turn(y)).norm(), six_digits);
  };
  expect_axes(X("# up y\n"), [](const Eigen::Vector3d& v) { return Eigen::Vector3d(v.x(), -v.z(), v.y()); });
  expect_axes(X("# up x\n"), [](const Eigen::Vector3d& v) { return Eigen::Vector3d(v.y(), v.z(), v.x()); });
  // Left-handed files are mirrored: z and y keep their meaning, x changes its side.
  expect_axes(X("# handedness left\n"), [](const Eigen::Vector3d& v) { return Eigen::Vector3d(v.x(), -v.y(), v.z()); });
  expect_axes(X("# up y\n# handedness left\n"),
              [](const Eigen::Vector3d& v) { return Eigen::Vector3d(v.x(), v.z(), v.y()); });
}

TEST(TraceCsv, LostRepeatedIncompleteAndNan) {
  const std::string one = hand_lines("0");
  const std::string incomplete = hand_lines("3").substr(0, hand_lines("3").rfind("3,0,right,palm"));
  const Trace trace =
      read("", one + one + "1,0,right,lost,,,,,,,,0.1\n" + hand_lines("2", "nan,0,0,1,0,0,0") + incomplete);
  ASSERT_EQ(trace.t.size(), 4u);
  EXPECT_TRUE(trace.hands[0].samples[0].tracked);
  EXPECT_EQ(trace.hands[0].samples[1].confidence, 0.1);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_FALSE(trace.hands[0].samples[i].tracked) << i;
  ASSERT_EQ(trace.warnings.size(), 3u);
  EXPECT_TRUE(starts_with(trace.warnings[0], "16 phalanges are given twice"));
  EXPECT_TRUE(starts_with(trace.warnings[1], "1 hand samples lack a phalanx"));
  EXPECT_TRUE(starts_with(trace.warnings[2], "1 hand samples have numbers that are not finite"));
}

TEST(TraceCsv, AHandThatComesLaterIsLostBefore) {
  const std::string second = "1,1,left,lost,,,,,,,,0\n";
  const Trace trace = read("", hand_lines("0") + hand_lines("1") + second);
  ASSERT_EQ(trace.hands.size(), 2u);
  EXPECT_EQ(trace.hands[1].side, Side::left);
  EXPECT_EQ(trace.hands[1].samples.size(), 2u);
}

TEST(TraceCsv, ReadsWindowsLines) {
  std::string text = "# handhold trace 1\n" + hand_lines("0");
  for (std::size_t i = 0; (i = text.find('\n', i)) != std::string::npos; i += 2) text.insert(i, "\r");
  EXPECT_EQ(read_trace_csv(text, "a.csv").t.size(), 1u);
}

TEST(TraceCsv, BadInputNamesFileAndLine) {
  const auto message = [](const std::string& header, const std::string& lines) {
    return message_of([&] { return read(header, lines); });
  };
  EXPECT_TRUE(starts_with(message("", "0,0,right,palm,1\n"), "a.csv:2: 5 fields"));
  EXPECT_TRUE(starts_with(message("", "0,0,right,palm,1,2,x,1,0,0,0,1\n"), "a.csv:2: \"x\" is not a number"));
  EXPECT_TRUE(starts_with(message("", "0,0,right,elbow,1,2,3,1,0,0,0,1\n"), "a.csv:2: phalanx \"elbow\""));
  EXPECT_TRUE(starts_with(message("", "0,0,both,palm,1,2,3,1,0,0,0,1\n"), "a.csv:2: side \"both\""));
  EXPECT_TRUE(starts_with(message("", "0,-1,left,palm,1,2,3,1,0,0,0,1\n"), "a.csv:2: hand -1"));
  EXPECT_TRUE(starts_with(message("", "0,0,left,palm,1,2,3,2,0,0,0,1\n"), "a.csv:2: quaternion of norm 2"));
  EXPECT_TRUE(
      starts_with(message("", hand_lines("1") + hand_lines("0.5")), "a.csv:18: the time stamp 0.5 s lies before"));
  EXPECT_TRUE(starts_with(message("", hand_lines("nan")), "a.csv:2: the time stamp is not finite"));
  EXPECT_TRUE(starts_with(message("", "0,0,right,lost,,,,,,,,0\n0,0,left,lost,,,,,,,,0\n"), "a.csv:3: hand 0 is left"));
  EXPECT_TRUE(starts_with(message("# unit inch\n", ""), "a.csv:2: unit \"inch\""));
  EXPECT_TRUE(starts_with(message("# up w\n", ""), "a.csv:2: up \"w\""));
  EXPECT_TRUE(starts_with(message("# time h\n", ""), "a.csv:2: time \"h\""));
  EXPECT_TRUE(starts_with(message("# handedness both\n", ""), "a.csv:2: handedness"));
  EXPECT_TRUE(starts_with(message("# capsule 0 palm 1 1\n", ""), "a.csv:2: the palm is no capsule"));
  EXPECT_TRUE(starts_with(message("# palm 0 1 -1 1\n", ""), "a.csv:2: length -1"));
  EXPECT_TRUE(starts_with(message("", ""), "a.csv: there is no hand"));
  EXPECT_TRUE(starts_with(message("", "0,0,left,palm,1,2,3,1,0,0,0,77\n"), "a.csv:2: confidence 77"));
  EXPECT_TRUE(contains(message_of([] { return read_trace_csv("# handhold trace 2\n", "a.csv"); }), "version 2"));
  EXPECT_TRUE(contains(message_of([] { return read_trace_csv(hand_lines("0"), "a.csv"); }), "is missing"));
}

// What would otherwise pass for a comment, or be dropped without a word.
TEST(TraceCsv, ShapesAndUnitsThatWouldBeIgnoredAreErrors) {
  const auto message = [](const std::string& header, const std::string& lines) {
    return message_of([&] { return read(header, lines); });
  };
  const std::string lines = hand_lines("0");
  EXPECT_EQ(message("# capsules are ours\n", lines), "accepted");
  EXPECT_TRUE(starts_with(message("# capsule 0 index_distal 0.005\n", lines), "a.csv:2: a capsule has four fields"));
  EXPECT_TRUE(starts_with(message("# palm 0 1 1\n", lines), "a.csv:2: a palm has four fields"));
  EXPECT_TRUE(starts_with(message("# palm 9 1 1 1\n", lines), "a.csv: hand 9 has a shape, but no line"));
  EXPECT_TRUE(starts_with(message("# palm 0 1 1 1\n# unit mm\n", lines), "a.csv:3: \"# unit\" stands below"));
  EXPECT_TRUE(starts_with(message("", lines + "# time ms\n"), "a.csv:18: \"# time\" stands below"));
  EXPECT_TRUE(starts_with(message("", "0,1,right,lost,,,,,,,,0\n"), "a.csv: there are 1 hands, but no line of hand 0"));
}

TEST(TraceCsv, AConfidenceThatIsNoNumberLosesTheSample) {
  std::string lines = hand_lines("0");
  lines.replace(lines.rfind(",0.5\n"), 5, ",nan\n");
  EXPECT_FALSE(read("", lines).hands[0].samples[0].tracked);
}

TEST(Trace, RefusesPlacesTimesAndConfidencesThatNoTrackerSees) {
  Trace trace = closing_hand(30);
  EXPECT_NO_THROW(validate(trace));
  trace.hands[0].samples[3].X_WP[palm].p.x() = 1e300;
  EXPECT_TRUE(contains(message_of([&] { return validate(trace), 0; }), "sample 3, palm lies farther than 1000000 m"));
  trace = closing_hand(30);
  trace.t.back() = 1.7e18;  // nanoseconds since 1970
  EXPECT_TRUE(contains(message_of([&] { return validate(trace), 0; }), "1.7e+18 s (check the unit of time)"));
  trace = closing_hand(30);
  trace.hands[0].samples[3].confidence = 1.5;
  EXPECT_TRUE(contains(message_of([&] { return validate(trace), 0; }), "sample 3: confidence 1.5"));
}

}  // namespace
}  // namespace handhold
