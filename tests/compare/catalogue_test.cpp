// The catalogue through the real engines: what `handhold suite` shows is what is asserted here.
#include <algorithm>

#include <gtest/gtest.h>

#include "cases/catalogue/case.hpp"
#include "compare/engine/engines.hpp"
#include "compare/judge/suite.hpp"

namespace handhold::compare {
namespace {

class Catalogue : public ::testing::TestWithParam<std::string> {};

TEST_P(Catalogue, EveryGateHolds) {
  if (std::ranges::count(engine_names(), "reference") == 0) GTEST_SKIP() << "built without the reference engine";
  const SuiteResult result = run_suite(*make_engine("reference"), *make_engine("realtime"), {.ids = {GetParam()}});
  for (const Gate* gate : gates(result)) EXPECT_TRUE(passes(*gate)) << sentence(*gate);
  EXPECT_TRUE(passed(result));
}

std::vector<std::string> ids() {
  std::vector<std::string> all;
  for (const catalogue::Case& c : catalogue::all_cases()) all.push_back(c.id);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, Catalogue, ::testing::ValuesIn(ids()),
                         [](const auto& parameter) { return parameter.param; });

TEST(Catalogue, HasTheTwoThresholdRunsWhereThereIsAThreshold) {
  for (const catalogue::Case& c : catalogue::all_cases()) {
    if (c.id != "C01" && c.id != "D01" && c.id != "D13") continue;
    int thresholds = 0;
    for (const catalogue::Run& run : c.runs) thresholds += run.name.find("of the threshold") != std::string::npos;
    EXPECT_EQ(thresholds, 2) << c.id;
  }
}

TEST(Catalogue, EveryNumberHasASourceAndEveryLimitAReason) {
  for (const catalogue::Case& c : catalogue::all_cases())
    for (const catalogue::Run& run : c.runs) {
      EXPECT_FALSE(run.expectations.empty()) << c.id;
      for (const catalogue::Expectation& e : run.expectations) {
        EXPECT_FALSE(e.source.empty()) << c.id << " " << e.quantity;
        EXPECT_FALSE(e.reference.reason.empty()) << c.id << " " << e.quantity;
        EXPECT_FALSE(e.realtime.reason.empty()) << c.id << " " << e.quantity;
        EXPECT_NE(e.pedigree, catalogue::Pedigree::regression) << c.id << " " << e.quantity;
      }
    }
}

}  // namespace
}  // namespace handhold::compare
