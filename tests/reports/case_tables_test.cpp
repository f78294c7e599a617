// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/case_tables.hpp"

#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"
#include "reports/data/results_json.hpp"
#include "tests/reports/sample_result.hpp"

namespace handhold::reports {
namespace {

const std::string document = "Before.\n<!-- table: cases L1 -->\nold\n<!-- end -->\nAfter.\n";

std::vector<CaseRow> rows() {
  return {{"L1-C01", "Incline", "v = |a| t", "L1", 2, 7, {{"rigid", 0.0432}}}, {"C01", "Other", "", "L2", 1, 1, {}}};
}

TEST(CaseTables, AreFilledBetweenTheirMarks) {
  EXPECT_EQ(with_tables(document, rows(), "d.md"),
            "Before.\n<!-- table: cases L1 -->\n"
            "| case | title | truth | runs | claims | rigid: error / limit |\n|---|---|---|---|---|---|\n"
            "| L1-C01 | Incline | v = \\|a\\| t | 2 | 7 | 0.04 |\n"
            "<!-- end -->\nAfter.\n");
}

TEST(CaseTables, AreStaleWhenARowIsMissingChangedOrTooMany) {
  const std::string fresh = with_tables(document, rows(), "d.md");
  EXPECT_TRUE(stale_rows(fresh, rows(), "d.md").empty());
  auto other = rows();
  other[0].worst.clear();  // figures do not count
  EXPECT_TRUE(stale_rows(fresh, other, "d.md").empty());
  other[0].claims = 8;
  EXPECT_EQ(stale_rows(fresh, other, "d.md").size(), 1u);
  other = rows();
  other[0].level = "L3";
  EXPECT_EQ(stale_rows(fresh, other, "d.md").size(), 1u);
  EXPECT_EQ(stale_rows(document, rows(), "d.md").size(), 1u);
}

void expect_refusal(const std::string& text, const std::string& word) {
  try {
    (void)with_tables(text, rows(), "d.md");
    ADD_FAILURE() << "no refusal: " << word;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(CaseTables, SayWhichMarkIsWrong) {
  expect_refusal("nothing", "has no table");
  expect_refusal("\n\n<!-- table: cases L1 -->\n", "d.md:3: a table has no end");
  expect_refusal("<!-- table: cases L9 -->\n<!-- end -->", "no such table");
}

TEST(CaseTables, TakeTheWorstOfEveryEngineFromTheResults) {
  compare::CaseResult of_case{.id = "X01", .title = "T", .formula = "f", .level = Level::compliant};
  compare::RunResult plain{.name = "a"}, mirrored{.name = "a", .variant = "mirrored"};
  plain.claims = {sample_claim("x", "m", 1, 1 + 1e-9, 1.5, 1e-8, 1)};
  mirrored.claims = {sample_claim("x", "m", 1, 1 + 2e-9, 1.5, 1e-8, 1)};
  of_case.runs = {plain, mirrored};
  const auto rows = case_rows(results_json({.cases = {of_case}}), "r.json");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].runs, 1u);
  EXPECT_EQ(rows[0].claims, 1u);
  EXPECT_NEAR(rows[0].worst.at("exact"), 0.2, 1e-6);
  EXPECT_EQ(rows[0].worst.at("fast"), 0.5);
  EXPECT_THROW((void)case_rows(std::string("{}"), "r.json"), InputError);
}

}  // namespace
}  // namespace handhold::reports
