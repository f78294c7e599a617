// SPDX-License-Identifier: GPL-3.0-or-later
// Every rigid case at other accuracies than the suite's: the limits say how errors follow the accuracy, and must hold.
#include <algorithm>

#include <gtest/gtest.h>

#include "compare/engine/engines.hpp"
#include "compare/judge/run_judge.hpp"

namespace handhold::compare {
namespace {

class RigidAccuracy : public ::testing::TestWithParam<std::tuple<std::string, double>> {};

TEST_P(RigidAccuracy, KeepsTheErrorBelowItsLimit) {
  const auto& [id, accuracy] = GetParam();
  const auto engine = make_engine("rigid");
  const SuiteOptions options{.engine = {.accuracy = accuracy}};
  const RunJudge judge({engine.get()}, options);
  for (const catalogue::Case& c : catalogue::all_cases()) {
    if (c.id != id) continue;
    for (const catalogue::Run& run : c.runs) {
      if (!run.variant.empty()) continue;  // the suite plays the variants, at its own accuracy
      const auto result = judge.judge(run, c.level);
      ASSERT_TRUE(result.has_value());
      for (const ClaimResult& claim : result->claims)
        for (const Judgement& j : claim.judgements)
          EXPECT_TRUE(j.gate && passes(*j.gate)) << run.name << ": " << (j.gate ? sentence(*j.gate) : j.why_not);
    }
  }
}

std::vector<std::string> rigid_ids() {
  std::vector<std::string> ids;
  const std::vector<std::string> engines = engine_names();
  if (std::ranges::find(engines, "rigid") == engines.end()) return ids;
  for (const catalogue::Case& c : catalogue::all_cases())
    if (c.level == Level::rigid) ids.push_back(c.id);
  return ids;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(RigidAccuracy);
INSTANTIATE_TEST_SUITE_P(L1, RigidAccuracy,
                         ::testing::Combine(::testing::ValuesIn(rigid_ids()), ::testing::Values(1e-8, 1e-12)),
                         [](const auto& made) {
                           std::string name = std::get<0>(made.param);
                           std::ranges::replace(name, '-', '_');
                           return name + (std::get<1>(made.param) > 1e-10 ? "_1em8" : "_1em12");
                         });

}  // namespace
}  // namespace handhold::compare
