// SPDX-License-Identifier: GPL-3.0-or-later
// What the last line says, whatever the table above it shows.
#include "compare/judge/verdict.hpp"

#include <gtest/gtest.h>

namespace handhold::compare {
namespace {

/// One claim with a gate for each of the measured errors, all with the limit 1.
SuiteResult result_of(const std::vector<double>& errors) {
  ClaimResult claim;
  for (const double error : errors) {
    claim.judgements.push_back({.engine = "e", .error = error});
    claim.judgements.back().gate = Gate{.quantity = "way", .measured = error, .limit = 1};
  }
  RunResult run;
  run.claims = {claim};
  CaseResult of_case;
  of_case.runs = {run};
  SuiteResult result;
  result.cases = {of_case};
  return result;
}

TEST(Verdict, SaysHowManyGatesGuardLittle) {
  EXPECT_EQ(verdict_sentence(result_of({0.5})), "Passed: all 1 gate of 1 case hold.");
  EXPECT_EQ(verdict_sentence(result_of({0.5, 1e-3})),
            "Passed: all 2 gates of 1 case hold; 1 of them is vacuous (over 100 times what was measured).");
  EXPECT_EQ(verdict_sentence(result_of({1e-3, 1e-3, 0.5})),
            "Passed: all 3 gates of 1 case hold; 2 of them are vacuous (over 100 times what was measured).");
}

TEST(Verdict, OneFailureAmongManyIsNoPass) {
  const SuiteResult result = result_of({0.5, 2, 0.5});
  EXPECT_FALSE(passed(result));
  EXPECT_EQ(headline(result), "Failed: 1 of 3 gates");
}

}  // namespace
}  // namespace handhold::compare
