// What the suite asks of engines, and how it is stopped within a run.
#include <gtest/gtest.h>

#include "compare/judge/suite.hpp"

namespace handhold::compare {
namespace {

/// An engine of ten frames that asks after every one whether to go on.
class Slow : public Engine {
 public:
  [[nodiscard]] std::string name() const override { return "slow"; }
  [[nodiscard]] Recording simulate(const Scene&, const EngineOptions&, const Progress& progress) const override {
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
  SuiteOptions options{.ids = {"C01"}, .study_refinements = {}};
  options.stop = [&] { return ++asked > 35; };  // the first run asks 20 times, the second would
  const SuiteResult result = run_suite(Slow(), Slow(), options);
  EXPECT_TRUE(result.interrupted);
  EXPECT_FALSE(passed(result));
  EXPECT_EQ(asked, 36);  // at once
  ASSERT_EQ(result.cases.size(), 1U);
  EXPECT_EQ(result.cases[0].runs.size(), 1U);
}

TEST(SuiteStop, RunsToItsEndWhenNobodyStopsIt) {
  const SuiteResult result = run_suite(Slow(), Slow(), {.ids = {"C01"}, .study_refinements = {}});
  EXPECT_FALSE(result.interrupted);
  EXPECT_EQ(result.cases[0].runs.size(), 3U);
}

/// The catalogue asks the thresholds of G02 of the reference alone.
TEST(SuiteAsks, TheRealTimePathOnlyWhatItCanBeAsked) {
  const SuiteResult result = run_suite(Slow(), Slow(), {.ids = {"G02"}, .study_refinements = {}});
  std::size_t asked = 0, not_asked = 0;
  for (const RunResult& run : result.cases.at(0).runs)
    for (const Finding& finding : run.findings) ++(finding.realtime.asked ? asked : not_asked);
  EXPECT_GT(asked, 0U);
  EXPECT_GT(not_asked, 0U);
  EXPECT_EQ(gates(result).size(), 2 * asked + not_asked);  // what was not asked is no gate, neither held nor failed
}

}  // namespace
}  // namespace handhold::compare
