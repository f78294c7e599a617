// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/recording/recording_csv.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/cases/input/expect_input_error.hpp"

namespace handhold {
namespace {

namespace fs = std::filesystem;

class RecordingCsv : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("handhold_") + info->name());
    fs::remove_all(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string text(const std::string& file) const {
    std::ifstream in(folder_ / file);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  void overwrite(const std::string& file, const std::string& content) const {
    std::ofstream(folder_ / file) << content;
  }

  /// Replaces the first `from` in the file.
  void replace(const std::string& file, const std::string& from, const std::string& to) const {
    std::string content = text(file);
    ASSERT_NE(content.find(from), std::string::npos) << content;
    overwrite(file, content.replace(content.find(from), from.size(), to));
  }

  fs::path folder_;
};

/// Numbers that no short decimal holds, names that need escapes.
Recording example() {
  Recording recording;
  recording.engine = "realtime";
  recording.scene = "a scene: with, commas";
  recording.outcome = Outcome::diverged;
  recording.note = "line one\nline \\two";
  recording.provenance = {{"compiler", "g++ 12"}, {"a:b", "c: d"}, {"empty", ""}};
  recording.body_names = {"mug", "lid, \"small\""};
  for (int i = 0; i < 3; ++i) {
    Frame frame;
    frame.t = i / 90.0;
    BodyState mug;
    mug.X_WO = {Eigen::Quaterniond(0.1, 0.2, 0.3, 0.4).normalized(), {1 / 3.0, -2 / 7.0, 1e-300}};
    mug.V_WO = {{i * 0.1, 1e22, -0.0}, {M_PI, 2, 3}};
    frame.bodies = {mug, BodyState{}};
    frame.energy = {1.1, 2.2, 3.3, 4.4, std::nextafter(5.5, 6)};
    recording.frames.push_back(frame);
  }
  recording.frames[2].bodies[1].X_WO.p.x() = std::numeric_limits<double>::infinity();  // it diverged
  ContactState a{{0, 2, 0, 1}, Mode::stick, 0.001, {1, 2, 3}, {4, 5, 6}, {0, 0, 1}, {0.1, 0.2, 0.3}};
  ContactState b{{1, 15, 1, 7}, Mode::slip, -0.002, {1, 2, 3}, {4, 5, 6}, {0, 1, 0}, {0.7, 0.8, 0.9}};
  recording.frames[1].contacts = {a, b};
  recording.events = {{0.01, 1e-12, EventKind::touch, a.id, recording.frames[0].bodies[0]},
                      {0.02, 0.001, EventKind::restick, b.id, recording.frames[1].bodies[0]}};
  recording.ambiguities = {{0.015, a.id, "touches on an edge, \"the first\" face is taken"}};
  recording.frame_time = {1e-5, 2e-5};
  return recording;
}

void expect_same(const BodyState& a, const BodyState& b) {
  EXPECT_EQ(a.X_WO.p, b.X_WO.p);
  EXPECT_EQ(a.X_WO.R.coeffs(), b.X_WO.R.coeffs());
  EXPECT_EQ(a.V_WO.v, b.V_WO.v);
  EXPECT_EQ(a.V_WO.w, b.V_WO.w);
}

void expect_same(const ContactState& a, const ContactState& b) {
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.mode, b.mode);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.p_W, b.p_W);
  EXPECT_EQ(a.C_W, b.C_W);
  EXPECT_EQ(a.n_W, b.n_W);
  EXPECT_EQ(a.f_W, b.f_W);
}

TEST_F(RecordingCsv, ReadsBackTheSameBits) {
  const Recording written = example();
  write_recording(written, folder_);
  const Recording read = read_recording(folder_);
  EXPECT_EQ(read.engine, written.engine);
  EXPECT_EQ(read.scene, written.scene);
  EXPECT_EQ(read.outcome, written.outcome);
  EXPECT_EQ(read.note, written.note);
  EXPECT_EQ(read.provenance, written.provenance);
  EXPECT_EQ(read.body_names, written.body_names);
  EXPECT_EQ(read.frame_time, written.frame_time);
  ASSERT_EQ(read.ambiguities.size(), 1u);
  EXPECT_EQ(read.ambiguities[0].t, 0.015);
  EXPECT_EQ(read.ambiguities[0].id, written.ambiguities[0].id);
  EXPECT_EQ(read.ambiguities[0].what, written.ambiguities[0].what);
  ASSERT_EQ(read.frames.size(), written.frames.size());
  for (std::size_t i = 0; i < read.frames.size(); ++i) {
    EXPECT_EQ(read.frames[i].t, written.frames[i].t);
    EXPECT_EQ(read.frames[i].energy.kinetic, written.frames[i].energy.kinetic);
    EXPECT_EQ(read.frames[i].energy.hand_work, written.frames[i].energy.hand_work);
    for (std::size_t b = 0; b < 2; ++b) expect_same(read.frames[i].bodies[b], written.frames[i].bodies[b]);
    ASSERT_EQ(read.frames[i].contacts.size(), written.frames[i].contacts.size());
    for (std::size_t c = 0; c < read.frames[i].contacts.size(); ++c) {
      expect_same(read.frames[i].contacts[c], written.frames[i].contacts[c]);
    }
  }
  ASSERT_EQ(read.events.size(), 2u);
  EXPECT_EQ(read.events[1].t, 0.02);
  EXPECT_EQ(read.events[1].window, 0.001);
  EXPECT_EQ(read.events[1].kind, EventKind::restick);
  EXPECT_EQ(read.events[1].id, (SampleId{1, 15, 1, 7}));
  for (std::size_t i = 0; i < 2; ++i) expect_same(read.events[i].body, written.events[i].body);
}

TEST_F(RecordingCsv, UnitsStandInTheColumnNames) {
  write_recording(example(), folder_);
  EXPECT_NE(text("frames.csv").find("\nt_s,mug.x_m,"), std::string::npos);
  EXPECT_NE(text("frames.csv").find("mug.wx_rad_per_s"), std::string::npos);
  EXPECT_NE(text("contacts.csv").find("depth_m"), std::string::npos);
  EXPECT_NE(text("events.csv").find("# engine: realtime\n"), std::string::npos);
  EXPECT_NE(text("frame_times.csv").find("cpu_time_s"), std::string::npos);
}

TEST_F(RecordingCsv, AnEmptyRecordingSurvives) {
  write_recording(Recording{}, folder_);
  const Recording read = read_recording(folder_);
  EXPECT_TRUE(read.frames.empty());
  EXPECT_TRUE(read.body_names.empty());
  EXPECT_EQ(read.outcome, Outcome::complete);
}

TEST_F(RecordingCsv, OverwritesAndLeavesNothingBeside) {
  write_recording(example(), folder_);
  write_recording(Recording{}, folder_);
  EXPECT_TRUE(read_recording(folder_).frames.empty());
  int files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder_)) ++files;
  EXPECT_EQ(files, 5);
}

TEST_F(RecordingCsv, AFullDiskIsAnErrorAndLeavesWhatWasThere) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full on this system";
  write_recording(example(), folder_);
  fs::create_symlink("/dev/full", folder_ / "contacts.csv.part");
  expect_input_error([&] { write_recording(Recording{}, folder_); }, {"contacts.csv.part", "cannot be written"});
  EXPECT_EQ(read_recording(folder_).frames.size(), 3u);
  EXPECT_FALSE(fs::exists(folder_ / "frames.csv.part"));
}

TEST_F(RecordingCsv, AFolderThatCannotBeMadeIsAnError) {
  std::ofstream(folder_.string()) << "a file";
  expect_input_error([&] { write_recording(example(), folder_); }, {"cannot be written"});
  expect_input_error([&] { write_recording(example(), folder_ / "below"); }, {"cannot be written"});
}

TEST_F(RecordingCsv, RefusesFramesThatDoNotFitTheNames) {
  Recording recording = example();
  recording.body_names.pop_back();
  expect_input_error([&] { write_recording(recording, folder_); }, {"2 bodies", "1 names"});
}

TEST_F(RecordingCsv, MissingFolderIsAnError) {
  expect_input_error([&] { (void)read_recording(folder_); }, {"frames.csv", "no such file"});
}

TEST_F(RecordingCsv, OnlyFramesAreRequired) {
  write_recording(example(), folder_);
  for (const char* file : {"contacts.csv", "events.csv", "frame_times.csv"}) fs::remove(folder_ / file);
  EXPECT_EQ(read_recording(folder_).frames.size(), 3u);
}

// Counting by hand: format, engine, scene, outcome, note, 2 bodies, 3 of provenance = 10 lines; 11 names; 12 is frame
// 0.
TEST_F(RecordingCsv, ABadNumberIsNamedWithItsLine) {
  write_recording(example(), folder_);
  replace("frames.csv", "\n0,0.33", "\n0,zero.33");
  expect_input_error([&] { (void)read_recording(folder_); }, {"frames.csv:12:", "'zero.33", "number"});
}

TEST_F(RecordingCsv, AMissingFieldIsNamedWithItsLine) {
  write_recording(example(), folder_);
  replace("events.csv", "0.01,1e-12,touch", "0.01,touch");
  expect_input_error([&] { (void)read_recording(folder_); }, {"events.csv:12:", "19 fields", "20"});
}

TEST_F(RecordingCsv, AnUnknownModeListsTheModes) {
  write_recording(example(), folder_);
  replace("contacts.csv", ",stick,", ",glued,");
  expect_input_error([&] { (void)read_recording(folder_); }, {"contacts.csv:12:", "'glued'", "apart, stick, slip"});
}

TEST_F(RecordingCsv, AFrameOrBodyOutOfRangeIsAnError) {
  write_recording(example(), folder_);
  const std::string good = text("contacts.csv");
  replace("contacts.csv", "\n1,", "\n3,");
  expect_input_error([&] { (void)read_recording(folder_); }, {"contacts.csv:12:", "'3'", "0 to 2"});
  overwrite("contacts.csv", good);
  replace("contacts.csv", ",1,15,1,7,", ",1,15,2,7,");
  expect_input_error([&] { (void)read_recording(folder_); }, {"contacts.csv:13:", "'2'", "0 to 1"});
}

TEST_F(RecordingCsv, ContactsOutOfOrderAreAnError) {
  write_recording(example(), folder_);
  replace("contacts.csv", ",0,2,0,1,", ",2,2,0,1,");
  expect_input_error([&] { (void)read_recording(folder_); }, {"contacts.csv:13:", "ascend"});
}

TEST_F(RecordingCsv, ColumnsThatDoNotFitTheBodiesAreAnError) {
  write_recording(example(), folder_);
  replace("frames.csv", "# body: mug\n", "");
  expect_input_error([&] { (void)read_recording(folder_); }, {"frames.csv:10:", "32 columns for 1 bodies", "19"});
}

TEST_F(RecordingCsv, AcceptsCrLfAndRemarks) {
  fs::create_directories(folder_);
  overwrite("frames.csv",
            "# my engine wrote this\r\n# body: a\r\nt_s,b,c,d,e,f,g,h,i,j,k,l,m,n,o,p,q,r,s\r\n"
            "0,1,2,3,1,0,0,0,4,5,6,7,8,9,0,0,0,0,0\r\n");
  const Recording read = read_recording(folder_);
  ASSERT_EQ(read.frames.size(), 1u);
  EXPECT_EQ(read.body_names.at(0), "a");
  EXPECT_EQ(read.frames[0].bodies[0].V_WO.w, Eigen::Vector3d(7, 8, 9));
}

TEST(RecordingNames, AreTheOnesOfTheFormat) {
  EXPECT_EQ(to_string(Mode::apart), "apart");
  EXPECT_EQ(to_string(EventKind::breakaway), "breakaway");
  EXPECT_EQ(to_string(Outcome::stalled), "stalled");
}

}  // namespace
}  // namespace handhold
