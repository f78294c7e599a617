// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/junit.hpp"

#include <gtest/gtest.h>

#include "compare/judge/verdict.hpp"
#include "tests/reports/markup.hpp"
#include "tests/reports/sample_result.hpp"

namespace handhold::reports {
namespace {

TEST(Markup, TheCheckerSeesFaults) {  // else the tests below could not fail
  EXPECT_EQ(markup_fault("<a b=\"&lt;\"><c/></a>"), "");
  EXPECT_NE(markup_fault("<a><b></a></b>"), "");
  EXPECT_NE(markup_fault("<a>1 & 2</a>"), "");
  EXPECT_NE(markup_fault("<a>"), "");
  EXPECT_NE(markup_fault("<a b=\"<c>\"></a>"), "");
}

TEST(Junit, IsWellFormed) { EXPECT_EQ(markup_fault(junit_xml(sample_result())), ""); }

TEST(Junit, HasOneSuiteACaseAndOneTestAJudgement) {
  const std::string xml = junit_xml(sample_result());
  EXPECT_EQ(occurrences(xml, "<testsuite "), 2u);
  EXPECT_EQ(occurrences(xml, "<testcase "), 9u);
  EXPECT_EQ(occurrences(xml, "<failure "), 2u);
  EXPECT_EQ(occurrences(xml, "<skipped message=\"not asked: it would ring\"/>"), 1u);
  EXPECT_NE(xml.find("<testsuites name=\"handhold\" tests=\"9\" failures=\"2\" errors=\"0\" skipped=\"1\""),
            std::string::npos);
}

TEST(Junit, FailureSaysTheGateInWords) {
  const compare::SuiteResult result = sample_result();
  const compare::Gate& failed = *result.cases[0].runs[0].claims[0].judgements[1].gate;
  std::string words = compare::sentence(failed);
  words.replace(words.find('>'), 1, "&gt;");
  EXPECT_NE(junit_xml(result).find("message=\"" + words + "\""), std::string::npos) << words;
}

/// Exactly one gate fails: every count says one, and the verdict is no pass.
TEST(Junit, OneFailureIsOne) {
  compare::SuiteResult result = sample_result();
  result.cases.pop_back();
  const std::string xml = junit_xml(result);
  EXPECT_EQ(occurrences(xml, "failures=\"1\""), 2u);  // the suite of the case, and all
  EXPECT_EQ(occurrences(xml, "<failure "), 1u);
  EXPECT_EQ(compare::verdict_sentence(result).rfind("Failed: 1 of the 5 gates of 1 case did not hold", 0), 0u)
      << compare::verdict_sentence(result);
}

TEST(Junit, AnInterruptedOrEmptyRunIsNoPass) {
  compare::SuiteResult empty, cut = sample_result();
  cut.interrupted = true;
  for (const compare::SuiteResult& result : {empty, cut}) {
    EXPECT_EQ(markup_fault(junit_xml(result)), "");
    EXPECT_EQ(occurrences(junit_xml(result), "<error "), 1u);
  }
}

TEST(Junit, ControlCharactersAndBrokenTextBecomeValidXml) {
  compare::SuiteResult result = sample_result();
  result.cases[0].runs[0].claims[0].judgements[1].gate->reason = std::string("a\x01\x1b[31m\xFF]]>", 11);
  const std::string xml = junit_xml(result);
  EXPECT_EQ(markup_fault(xml), "");
  EXPECT_EQ(xml.find('\x01'), std::string::npos);
  EXPECT_EQ(xml.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace handhold::reports
