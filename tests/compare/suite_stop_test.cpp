// SPDX-License-Identifier: GPL-3.0-or-later
// What the suite asks of engines, and how it is stopped within a run.
#include <gtest/gtest.h>

#include "compare/judge/suite.hpp"
#include "compare/judge/verdict.hpp"

namespace handhold::compare {
namespace {

/// An engine of ten frames that asks after every one whether to go on.
class Slow : public Engine {
 public:
  [[nodiscard]] EngineInfo info(const EngineOptions& options) const override {
    return {.name = "slow",
            .levels = {Level::compliant},
            .errs = {ErrorModel::Kind::controlled, options.accuracy, 0},
            .records = {true, true, true, true}};
  }
  [[nodiscard]] Recording play(const Problem&, const EngineOptions&, const Progress& progress) const override {
    Recording recording;
    for (int i = 0; i < 10; ++i) {
      recording.frames.push_back({.t = 0.1 * i, .bodies = {BodyState{}}});
      if (!progress(0.1 * i)) {
        recording.outcome = Outcome::interrupted;
        break;
      }
    }
    return recording;
  }
};

TEST(SuiteStop, DropsTheRunThatWasStoppedAndKeepsThoseBefore) {
  int asked = 0;
  SuiteOptions options{.ids = {"C01"}, .study_refinements = {}, .variants = false, .threads = 1};
  options.stop = [&] { return ++asked > 37; };  // the first run asks 20 times, the second would
  const Slow slow;
  const SuiteResult result = run_suite({&slow, &slow}, options);
  EXPECT_TRUE(result.interrupted);
  EXPECT_FALSE(passed(result));
  EXPECT_EQ(asked, 38);  // at once
  ASSERT_EQ(result.cases.size(), 1U);
  EXPECT_EQ(result.cases[0].runs.size(), 1U);
}

TEST(SuiteStop, RunsToItsEndWhenNobodyStopsIt) {
  const Slow slow;
  const SuiteResult result = run_suite({&slow, &slow}, {.ids = {"C01"}, .study_refinements = {}, .variants = false});
  EXPECT_FALSE(result.interrupted);
  EXPECT_EQ(result.cases[0].runs.size(), 3U);
}

/// An engine with a fixed step.
class Stepping : public Slow {
 public:
  [[nodiscard]] EngineInfo info(const EngineOptions&) const override {
    return {.name = "stepping",
            .levels = {Level::compliant},
            .errs = {ErrorModel::Kind::stepped, 0, 1.0 / 360},
            .records = {true, true, true, true}};
  }
};

/// The catalogue asks the thresholds of G02 of engines that control their error alone.
TEST(SuiteAsks, OnlyWhatAnEngineCanBeAsked) {
  const Slow slow;
  const Stepping stepping;
  const SuiteResult result = run_suite({&slow, &stepping}, {.ids = {"G02"}, .study_refinements = {}});
  const Count n = count(result);
  EXPECT_GT(n.not_asked, 0U);
  std::size_t claims = 0;
  for (const RunResult& run : result.cases.at(0).runs) claims += run.claims.size();
  EXPECT_EQ(n.gates + n.not_asked, 2 * claims);  // what was not asked is no gate, neither held nor failed
  EXPECT_GT(n.gates, claims);
}

TEST(SuiteAsks, NobodyAboutALevelThatItDoesNotPlay) {
  const Slow slow;
  const SuiteResult result = run_suite({&slow}, {.levels = {Level::rigid}, .study_refinements = {}});
  EXPECT_EQ(count(result).gates, 0U);
}

}  // namespace
}  // namespace handhold::compare
