// SPDX-License-Identifier: GPL-3.0-or-later
// What a foreign process can do wrong, each told in a sentence.
#include "compare/engine/process.hpp"

#include <chrono>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <unistd.h>

#include "cases/input/recording/recording_csv.hpp"
#include "compare/engine/process_engine.hpp"
#include "compare/measure/measure.hpp"
#include "tests/cases/input/expect_input_error.hpp"
#include "tests/compare/engine/problems.hpp"

namespace handhold::compare::testing {
namespace {

namespace fs = std::filesystem;

const std::string block_engine = "python3 '" HANDHOLD_BLOCK_ENGINE "' {problem} {out}";

SampledProblem stop_problem() { return sample(sliding_block(), "stop", 1.0 / 360); }

ProcessAnswer answer_to(const std::string& command, double time_limit = 60) {
  return play_in_process(stop_problem(), {.command = command, .time_limit = time_limit});
}

/// The example's answer, changed by sed.
ProcessAnswer edited(const std::string& sed) {
  return answer_to(block_engine + " && sed -i '" + sed + "' {out}/frames.csv");
}

void expect_fault(const ProcessAnswer& answer, const std::string& part) {
  EXPECT_FALSE(answer.recording);
  EXPECT_EQ(answer.not_asked, "");
  EXPECT_NE(answer.fault.find(part), std::string::npos) << answer.fault;
}

/// Where a block stops that keeps in each step the velocity of its end: v²/(2 μ g), and v h/2 less. Within the way of
/// its last step, which friction does not use up.
double stopped_at(double h) { return 0.8 * 0.8 / (2 * 0.4 * g) - 0.8 * h / 2; }
double stop_rounding(double h) { return 0.4 * g * h * h; }

TEST(Process, TheExamplePlaysABlockThatStops) {
  const ProcessAnswer answer = answer_to(block_engine);
  ASSERT_TRUE(answer.recording) << answer.fault << answer.not_asked << answer.output;
  EXPECT_EQ(answer.recording->frames.size(), 109u);
  EXPECT_NEAR(answer.recording->frames.back().bodies[0].X_WO.p.x(), stopped_at(1.0 / 360), stop_rounding(1.0 / 360));
  EXPECT_EQ(answer.recording->frames.back().bodies[0].V_WO.v.x(), 0);
  EXPECT_TRUE(std::isnan(answer.recording->frames.back().energy.kinetic));  // not recorded is not zero
}

TEST(Process, SaysWhatItIsNotAsked) {
  const ProcessAnswer answer = play_in_process(sample(rich_problem(), "rich", 1.0 / 360), {.command = block_engine});
  EXPECT_FALSE(answer.recording);
  EXPECT_EQ(answer.fault, "");
  EXPECT_EQ(answer.not_asked, "it knows one block on one support, without springs");
  expect_fault(answer_to("echo sorry; exit 4 # {problem} {out}"), "without {\"not_asked\"");
}

TEST(Process, ThatHangsIsKilledWithAllItStarted) {
  const fs::path alive = fs::temp_directory_path() / ("handhold_alive_" + std::to_string(::getpid()));
  fs::remove(alive);
  const auto start = std::chrono::steady_clock::now();
  const ProcessAnswer answer = answer_to("(sleep 2; touch '" + alive.string() + "') & sleep 60 # {problem} {out}", 0.5);
  expect_fault(answer, "still running after 0.5 s and was killed");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  std::this_thread::sleep_for(std::chrono::milliseconds(2500));
  EXPECT_FALSE(fs::exists(alive));
}

TEST(Process, ThatDiesIsToldWithItsLastWords) {
  expect_fault(answer_to("echo one; echo no memory for it >&2; exit 3 # {problem} {out}"),
               "exit code 3: no memory for it");
  expect_fault(answer_to("kill -SEGV $$ # {problem} {out}"), "signal 11 (Segmentation fault)");
  expect_fault(answer_to("no_such_program_of_mine {problem} {out}"), "exit code 127");
}

TEST(Process, WrongAnswersAreTold) {
  expect_fault(answer_to("true {problem} {out}"), "wrote no frames.csv");
  expect_fault(edited("50s/,[^,]*/,nan/"), "frame 45 (t = 0.125 s), body 'body': a number that is not finite");
  expect_fault(edited("50s/,1.0,0.0,0.0,0.0,/,1.0,1.0,0.0,0.0,/"), "quaternion is not of length 1");
  expect_fault(edited("60,$d"), "has 55 frames, the problem asks for 109");
  expect_fault(edited("$p"), "has 110 frames, the problem asks for 109");
  expect_fault(edited("30d"), "frame 25 is at t =");
  expect_fault(edited("s/# scene: stop/# scene: another/"), "answers the problem 'another', not 'stop'");
  expect_fault(edited("s/# body: body/# body: mug/"), "has the bodies [mug], the problem has [body]");
  expect_fault(edited("50s/,/;/"), "cannot be read");
}

TEST(Process, FillsItsOutputWithoutStanding) {  // a pipe that nobody reads would stop it at 64 kB
  const ProcessAnswer answer = answer_to("yes | head -c 1000000; " + block_engine);
  EXPECT_TRUE(answer.recording) << answer.fault;
}

TEST(Process, ItsFolderMayHaveAnyName) {
  const fs::path folder = fs::temp_directory_path() / "hand hold's $(true)";
  fs::remove_all(folder);
  const ProcessAnswer answer = play_in_process(stop_problem(), {.command = block_engine, .folder = folder});
  EXPECT_TRUE(answer.recording) << answer.fault;
  EXPECT_TRUE(fs::exists(folder / "out" / "frames.csv"));
  fs::remove_all(folder);
}

TEST(Process, RefusesACommandWithoutItsPlaces) {
  expect_input_error([] { return answer_to("python3 mine.py {problem}"); }, {"must contain {out}"});
  expect_input_error([] { return answer_to("x {problem} {out}", 0); }, {"time_limit=0"});
  expect_input_error([] { return process_engine_from("python3"); }, {"must be NAME=COMMAND"});
}

TEST(ProcessEngine, IsAnEngineOfL1) {
  const auto engine = process_engine_from("mine=" + block_engine);
  EXPECT_EQ(engine->info({}).name, "mine");
  EXPECT_EQ(engine->why_not(sliding_block()), "");
  EXPECT_EQ(engine->why_not(rich_problem()), "it knows one block on one support, without springs");
  const Recording recording = engine->play(sliding_block(), {.frame_rate = 90, .substeps = 4}, {});
  EXPECT_EQ(recording.frames.size(), 28u);
  const catalogue::Measure place{.kind = catalogue::Measure::Kind::displacement, .at = 0.3};
  EXPECT_NEAR(measure(sliding_block(), recording, place), stopped_at(1.0 / 360), stop_rounding(1.0 / 360));
}

TEST(ProcessEngine, ThatFailsLosesOnlyItsOwnRows) {
  const auto engine = process_engine_from("mine=exit 3 # {problem} {out}");
  const Recording recording = engine->play(sliding_block(), {}, {});
  EXPECT_EQ(recording.outcome, Outcome::stalled);
  EXPECT_NE(recording.note.find("exit code 3"), std::string::npos);
  EXPECT_TRUE(std::isnan(measure(sliding_block(), recording, {.at = 0.3})));
}

TEST(ProcessEngine, CheckSaysWhatIsMissing) {
  const std::vector<std::string> missing = what_is_missing({.command = block_engine});
  ASSERT_EQ(missing.size(), 1u);
  EXPECT_EQ(missing[0], "a block that is pressed: not asked: it knows one block on one support, without springs");
}

/// The engines from npm play what the example plays, where they are installed.
class NpmEngine : public ::testing::TestWithParam<std::string> {};

TEST_P(NpmEngine, StopsABlockWithinAStep) {
  if (!npm_engine_is_installed(GetParam())) GTEST_SKIP() << GetParam() << " is not installed (./dev engines)";
  const auto engine = make_npm_engine(GetParam());
  const Recording recording = engine->play(sliding_block(), {.frame_rate = 90, .substeps = 4}, {});
  ASSERT_EQ(recording.frames.size(), 28u) << recording.note;
  const double step = 0.8 / 360;  // way of a step at the start: far below the way to the stop, far above rounding
  EXPECT_NEAR(recording.frames.back().bodies[0].X_WO.p.x(), 0.8 * 0.8 / (2 * 0.4 * g), step);
}

INSTANTIATE_TEST_SUITE_P(All, NpmEngine, ::testing::ValuesIn(npm_engine_names()),
                         [](const auto& made) { return made.param; });

}  // namespace
}  // namespace handhold::compare::testing
