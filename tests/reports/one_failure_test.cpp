// SPDX-License-Identifier: GPL-3.0-or-later
// One failed gate shows in every output: none says that all is well.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "compare/judge/verdict.hpp"
#include "reports/data/junit.hpp"
#include "reports/data/results_json.hpp"
#include "reports/data/table.hpp"
#include "tests/reports/sample_result.hpp"

namespace handhold::reports {
namespace {

TEST(OneFailure, IsNoPassAnywhere) {
  compare::SuiteResult result = sample_result();
  result.cases.pop_back();  // what is left fails once
  ASSERT_EQ(compare::count(result).failed, 1u);
  EXPECT_FALSE(compare::passed(result));
  EXPECT_EQ(compare::headline(result), "Failed: 1 of 5 gates");
  EXPECT_EQ(compare::verdict_sentence(result).find("Passed"), std::string::npos);
  EXPECT_EQ(text_table(result).find("Passed"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(results_json(result)).at("verdict").at("failed"), 1);
  EXPECT_EQ(junit_xml(result).find("failures=\"0\""), std::string::npos);
}

}  // namespace
}  // namespace handhold::reports
