#include "reports/data/results_json.hpp"

#include <fstream>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/reports/json_schema.hpp"
#include "tests/reports/sample_result.hpp"

namespace handhold::reports {
namespace {

using nlohmann::json;

json schema() { return json::parse(std::ifstream(HANDHOLD_RESULTS_SCHEMA)); }

TEST(ResultsJson, SaysTheVerdictAndCountsGates) {
  const json verdict = json::parse(results_json(sample_result()))["verdict"];
  EXPECT_EQ(verdict["passed"], false);
  EXPECT_EQ(verdict["gates"], 7);    // three findings with two gates each, and one order study
  EXPECT_EQ(verdict["failed"], 2);   // the late onset and the NaN
  EXPECT_EQ(verdict["vacuous"], 1);  // 1e-12 against 1e-9
}

TEST(ResultsJson, FitsItsSchema) {
  EXPECT_EQ(schema_fault(json::parse(results_json(sample_result())), schema(), schema()), "");
  EXPECT_EQ(schema_fault(json::parse(results_json({})), schema(), schema()), "");
}

TEST(ResultsJson, TheSchemaRefusesWhatIsNoResult) {  // a schema that accepts everything would pass the test above
  json result = json::parse(results_json(sample_result()));
  result["cases"][0]["runs"][0]["findings"][0]["realtime"]["gate"].erase("reason");
  EXPECT_EQ(schema_fault(result, schema(), schema()), "/cases/0/runs/0/findings/0/realtime/gate: lacks reason");
}

TEST(ResultsJson, WritesNanAsNullWithAText) {
  const json finding = json::parse(results_json(sample_result()))["cases"][1]["runs"][0]["findings"][0];
  EXPECT_TRUE(finding["realtime"]["value"].is_null());
  EXPECT_EQ(finding["realtime"]["value_text"], "nan");
  EXPECT_EQ(finding["realtime"]["gate"]["passes"], false);
  EXPECT_TRUE(finding["realtime"]["gate"]["slack"].is_null());
}

TEST(ResultsJson, WritesInfinitiesInListsWithTheirPlace) {
  compare::SuiteResult result = sample_result();
  result.cases[0].runs[0].curve.realtime[3] = -std::numeric_limits<double>::infinity();
  const json document = json::parse(results_json(result)), curve = document["cases"][0]["runs"][0]["curve"];
  EXPECT_TRUE(curve["realtime"][3].is_null());
  EXPECT_EQ(curve["realtime_text"], json({{"3", "-inf"}}));
  EXPECT_EQ(schema_fault(document, schema(), schema()), "");
}

TEST(ResultsJson, WhatWasNotAskedIsLeftOut) {
  compare::SuiteResult result = sample_result();
  compare::RunResult& run = result.cases[0].runs[0];
  for (compare::Finding& finding : run.findings) finding.realtime = {.asked = false};
  run.realtime_note = "not asked: it would ring";
  const json written = json::parse(results_json(result));
  EXPECT_FALSE(written["cases"][0]["runs"][0]["findings"][0].contains("realtime"));
  EXPECT_EQ(schema_fault(written, schema(), schema()), "");
}

TEST(ResultsJson, NumbersRoundTrip) {
  compare::SuiteResult result = sample_result();
  const double awkward = 0.1 + 0.2;  // needs 17 digits
  result.cases[0].runs[0].findings[0].expectation.truth = awkward;
  EXPECT_EQ(json::parse(results_json(result))["cases"][0]["runs"][0]["findings"][0]["truth"].get<double>(), awkward);
}

TEST(ResultsJson, SlackIsLimitOverMeasured) {
  const json gate =
      json::parse(results_json(sample_result()))["cases"][1]["runs"][0]["findings"][0]["reference"]["gate"];
  // |1.25 + 1e-12 − 1.25| is 1e-12 but for the rounding of 1.25 + 1e-12: half of 2.2e-16, so 1.1e-4 of it.
  EXPECT_NEAR(gate["slack"].get<double>(), 1000, 1000 * 1.2e-4);
  EXPECT_EQ(gate["vacuous"], true);
}

TEST(ResultsJson, SameBytesForTheSameResult) {
  EXPECT_EQ(results_json(sample_result()), results_json(sample_result()));
}

TEST(ResultsJson, SurvivesBytesThatAreNoText) {
  compare::SuiteResult result = sample_result();
  result.cases[0].title = "\xFF\xC0 title";
  result.provenance["\xFE"] = "\xFE";
  EXPECT_NO_THROW(json::parse(results_json(result)));
}

}  // namespace
}  // namespace handhold::reports
