// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/table.hpp"

#include <sstream>

#include <gtest/gtest.h>

#include "reports/data/text.hpp"
#include "tests/reports/sample_result.hpp"

namespace handhold::reports {
namespace {

std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of('\n');
  return text.substr(text.rfind('\n', end) + 1, end - text.rfind('\n', end));
}

TEST(Table, EndsWithTheVerdictInOneSentence) {
  EXPECT_EQ(last_line(text_table(sample_result())).rfind("Failed: 2 of the 8 gates of 2 cases did not hold", 0), 0u);
}

TEST(Table, SaysEveryVerdictInAWord) {
  const std::string table = text_table(sample_result());
  EXPECT_NE(table.find("FAIL\n"), std::string::npos);
  EXPECT_NE(table.find("pass\n"), std::string::npos);
  EXPECT_NE(table.find("none"), std::string::npos);  // the stop that was never seen
  EXPECT_NE(table.find("Vacuous gates"), std::string::npos);
  EXPECT_NE(table.find("1.01±0.02"), std::string::npos);
  EXPECT_NE(table.find("1: it would ring"), std::string::npos);
  EXPECT_NE(table.find("fast ended early: diverged"), std::string::npos);
}

TEST(Table, ColourOnlyWhenAsked) {
  EXPECT_EQ(text_table(sample_result()).find('\x1b'), std::string::npos);
  EXPECT_NE(text_table(sample_result(), {true}).find('\x1b'), std::string::npos);
}

TEST(Table, RowsFitTheTerminal) {
  std::istringstream table(text_table(sample_result()));
  std::string line;
  for (std::getline(table, line); line.rfind("===", 0) != 0; std::getline(table, line)) {
  }
  EXPECT_EQ(width(line), 140u);
  for (std::getline(table, line); line.rfind("===", 0) != 0; std::getline(table, line))
    EXPECT_LE(width(line), 140u) << line;
}

TEST(Table, ATitleCannotSendCommandsToTheTerminal) {
  compare::SuiteResult result = sample_result();
  result.cases[0].title = "\x1b]0;gone\x07\nnew line";
  const std::string table = text_table(result);
  EXPECT_EQ(table.find('\x1b'), std::string::npos);
  EXPECT_EQ(table.find("\nnew line"), std::string::npos);
}

TEST(Table, NothingJudgedIsNoPass) {
  EXPECT_EQ(last_line(text_table({})), "Failed: no gate was judged, and nothing judged is no pass.");
}

}  // namespace
}  // namespace handhold::reports
