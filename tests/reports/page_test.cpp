// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cases/model/input_error.hpp"
#include "reports/data/deflate.hpp"
#include "reports/data/merge_results.hpp"
#include "reports/data/page_data.hpp"
#include "reports/data/results_json.hpp"
#include "tests/reports/sample_result.hpp"

namespace handhold::reports {
namespace {

using nlohmann::json;

StoredReport sample() { return stored_report(sample_result()); }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Page, HoldsResultsTimesAndRecordings) {
  StoredReport report = sample();
  report.recordings["recording-1"] = "some bytes";
  const std::string html = page(report);
  EXPECT_TRUE(contains(html, base64("some bytes")) || !contains(html, "id=\"results\""));  // a plain page has none
  EXPECT_TRUE(contains(html, base64(deflated(report.results))) || !contains(html, "id=\"results\""));
  EXPECT_FALSE(contains(html, "<!--handhold:"));
}

TEST(Page, TitleAndTableAreTheVerdict) {
  const std::string html = page(sample());
  EXPECT_TRUE(contains(html, "<title>✗ ")) << html.substr(0, 400);
  EXPECT_TRUE(contains(html, "<th>exact</th><th>fast</th>"));
  EXPECT_TRUE(contains(html, "✗ fails 1 of "));
}

TEST(Page, EscapesWhatStandsInTheTable) {
  compare::SuiteResult result = sample_result();
  result.cases[0].title = "<b>\"'&";
  const std::string html = page(stored_report(result));
  EXPECT_TRUE(contains(html, "&lt;b&gt;&quot;&#39;&amp;"));
  EXPECT_FALSE(contains(html, "<b>\"'&"));
}

TEST(Page, SameBytesForTheSameReport) { EXPECT_EQ(page(sample()), page(sample())); }

TEST(Page, RefusesOtherVersionsInWords) {
  for (const std::string& wrong :
       {std::string("no json"), std::string(R"({"format": "handhold results", "version": 1})")}) {
    try {
      (void)page({wrong, "", {}});
      FAIL() << "no error";
    } catch (const InputError& error) {
      EXPECT_TRUE(contains(error.what(), "version 2 (run handhold suite")) << error.what();
    }
  }
}

json merged_json(std::vector<NamedReport> parts) { return json::parse(merged(std::move(parts)).results); }

TEST(Merge, OneReportStaysAsItIs) { EXPECT_EQ(merged_json({{"a", sample()}}), json::parse(sample().results)); }

TEST(Merge, PartsOfASuiteBecomeTheWhole) {
  compare::SuiteResult first = sample_result(), second = sample_result();
  first.cases.pop_back();
  second.cases.erase(second.cases.begin());
  const json all = merged_json({{"a", stored_report(first)}, {"b", stored_report(second)}});
  const json whole = json::parse(sample().results);
  EXPECT_EQ(all["cases"], whole["cases"]);
  EXPECT_EQ(all["engines"], whole["engines"]);
  for (const char* key : {"gates", "failed", "vacuous", "not_asked", "passed"})
    EXPECT_EQ(all["verdict"][key], whole["verdict"][key]) << key;
}

TEST(Merge, TheSameEngineTwiceIsTwoEngines) {
  const json all = merged_json({{"before", sample()}, {"after", sample()}});
  const json whole = json::parse(sample().results);
  EXPECT_EQ(all["engines"].size(), 2 * whole["engines"].size());
  EXPECT_EQ(all["engines"].back()["name"], "fast (after)");
  EXPECT_EQ(all["verdict"]["gates"].get<int>(), 2 * whole["verdict"]["gates"].get<int>());
  const json& claim = all["cases"][0]["runs"][0]["claims"][0];
  EXPECT_EQ(claim["judgements"][2]["engine"], "exact (after)");
  EXPECT_TRUE(all["cases"][0]["runs"][0]["curve"]["engines"].contains("fast (after)"));
}

TEST(Merge, TimesFollowTheirEngines) {
  const json times = json::parse(merged({{"before", sample()}, {"after", sample()}}).times);
  EXPECT_EQ(times["plays"].back()["engine"].get<std::string>().find("(after)") != std::string::npos, true);
}

TEST(Merge, RefusesWhatIsNoReport) {
  EXPECT_THROW((void)merged({}), InputError);
  EXPECT_THROW((void)merged({{"a", sample()}, {"b", {"{}", "", {}}}}), InputError);
}

}  // namespace
}  // namespace handhold::reports
