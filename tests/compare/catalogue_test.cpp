// SPDX-License-Identifier: GPL-3.0-or-later
// The catalogue through the real engines: what `handhold suite` shows is what is asserted here.
#include <algorithm>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "cases/catalogue/case.hpp"
#include "compare/engine/engines.hpp"
#include "compare/judge/suite.hpp"
#include "compare/judge/verdict.hpp"

namespace handhold::compare {
namespace {

class Catalogue : public ::testing::TestWithParam<std::string> {};

TEST_P(Catalogue, EveryGateHolds) {
  std::vector<std::unique_ptr<Engine>> owned;
  std::vector<const Engine*> engines;
  for (const std::string& name : engine_names()) {
    owned.push_back(make_engine(name));
    if (owned.back()->info({}).errs.kind != ErrorModel::Kind::foreign) engines.push_back(owned.back().get());
  }
  const SuiteResult result = run_suite(engines, {.ids = {GetParam()}, .threads = 1});
  for (const PlacedGate& gate : placed_gates(result)) EXPECT_TRUE(passes(*gate.gate)) << sentence(*gate.gate);
  EXPECT_TRUE(passed(result));
}

std::vector<std::string> ids() {
  std::vector<std::string> all;
  for (const catalogue::Case& c : catalogue::all_cases()) all.push_back(c.id);
  return all;
}

INSTANTIATE_TEST_SUITE_P(All, Catalogue, ::testing::ValuesIn(ids()), [](const auto& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Catalogue, AClaimIsKnownByItsNames) {  // a report, a merge and the baseline know it by these
  for (const catalogue::Case& c : catalogue::all_cases()) {
    std::set<std::string> names;
    for (const catalogue::Run& run : c.runs)
      for (const catalogue::Claim& claim : run.claims)
        EXPECT_TRUE(names.insert(run.name + "/" + run.variant + "/" + claim.quantity).second)
            << c.id << ", " << run.name << ": '" << claim.quantity << "' is there twice";
  }
}

TEST(Catalogue, HasTheTwoThresholdRunsWhereThereIsAThreshold) {
  for (const catalogue::Case& c : catalogue::all_cases()) {
    if (c.id != "C01" && c.id != "D01" && c.id != "D13") continue;
    int thresholds = 0;
    for (const catalogue::Run& run : c.runs)
      thresholds += run.variant.empty() && run.name.find("of the threshold") != std::string::npos;
    EXPECT_EQ(thresholds, 2) << c.id;
  }
}

TEST(Catalogue, EveryNumberHasASourceAndEveryLimitAReason) {
  for (const catalogue::Case& c : catalogue::all_cases())
    for (const catalogue::Run& run : c.runs) {
      EXPECT_FALSE(run.claims.empty()) << c.id;
      for (const catalogue::Claim& e : run.claims) {
        EXPECT_FALSE(e.source.empty()) << c.id << " " << e.quantity;
        EXPECT_FALSE(e.controlled.reason.empty()) << c.id << " " << e.quantity;
        EXPECT_FALSE(e.stepped.reason.empty()) << c.id << " " << e.quantity;
        EXPECT_NE(e.pedigree, catalogue::Pedigree::regression) << c.id << " " << e.quantity;
      }
    }
}

}  // namespace
}  // namespace handhold::compare
