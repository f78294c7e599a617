#include "reports/data/junit.hpp"

#include <gtest/gtest.h>

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

TEST(Junit, HasOneSuiteACaseAndOneTestAGate) {
  const std::string xml = junit_xml(sample_result());
  EXPECT_EQ(occurrences(xml, "<testsuite "), 2u);
  EXPECT_EQ(occurrences(xml, "<testcase "), 7u);
  EXPECT_EQ(occurrences(xml, "<failure "), 2u);
  EXPECT_NE(xml.find("<testsuites name=\"handhold\" tests=\"7\" failures=\"2\" errors=\"0\""), std::string::npos);
}

TEST(Junit, FailureSaysTheGateInWords) {
  const compare::SuiteResult result = sample_result();
  const compare::Gate& failed = result.cases[0].runs[0].findings[0].realtime.gate;
  std::string words = compare::sentence(failed);
  words.replace(words.find('>'), 1, "&gt;");
  EXPECT_NE(junit_xml(result).find("message=\"" + words + "\""), std::string::npos) << words;
}

TEST(Junit, SumsOfTestTimesAreTheRunsTimes) {  // 0.42 s + 0.012 s over the four gates of the two engines
  EXPECT_NE(junit_xml(sample_result()).find("\" time=\"0.432000\">"), std::string::npos);
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
  result.cases[0].runs[0].findings[0].realtime.gate.reason = std::string("a\x01\x1b[31m\xFF]]>", 11);
  const std::string xml = junit_xml(result);
  EXPECT_EQ(markup_fault(xml), "");
  EXPECT_EQ(xml.find('\x01'), std::string::npos);
  EXPECT_EQ(xml.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace handhold::reports
