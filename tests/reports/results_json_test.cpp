// SPDX-License-Identifier: GPL-3.0-or-later
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

json claim(const json& document, int of_case, int index) {
  return document["cases"][std::size_t(of_case)]["runs"][0]["claims"][std::size_t(index)];
}

TEST(ResultsJson, SaysTheVerdictAndCountsGates) {
  const json verdict = json::parse(results_json(sample_result()))["verdict"];
  EXPECT_EQ(verdict["passed"], false);
  EXPECT_EQ(verdict["gates"], 8);    // three claims with two gates each, one with one, and one order study
  EXPECT_EQ(verdict["failed"], 2);   // the late onset and the NaN
  EXPECT_EQ(verdict["vacuous"], 1);  // 1e-12 against 1e-9
  EXPECT_EQ(verdict["not_asked"], 1);
}

TEST(ResultsJson, FitsItsSchema) {
  EXPECT_EQ(schema_fault(json::parse(results_json(sample_result())), schema(), schema()), "");
  EXPECT_EQ(schema_fault(json::parse(results_json({})), schema(), schema()), "");
}

TEST(ResultsJson, SaysWhatMovedSinceTheBaseline) {
  compare::SuiteResult result = sample_result();
  EXPECT_FALSE(json::parse(results_json(result)).contains("moved"));
  result.moved = {
      {{"C01", "slides", "slip onset", "fast"}, compare::Movement::away, {0.2, 0.201, 0.01}, {0.2, 0.202, 0.01}}};
  const json document = json::parse(results_json(result));
  EXPECT_EQ(document["moved"][0]["movement"], "away from");
  EXPECT_EQ(schema_fault(document, schema(), schema()), "");
}

TEST(ResultsJson, TheSchemaRefusesWhatIsNoResult) {  // a schema that accepts everything would pass the test above
  json result = json::parse(results_json(sample_result()));
  result["cases"][0]["runs"][0]["claims"][0]["judgements"][1].erase("state");
  EXPECT_EQ(schema_fault(result, schema(), schema()), "/cases/0/runs/0/claims/0/judgements/1: lacks state");
}

/// An engine is data: its name stands in values and, in curves and settings, in keys; never in the schema.
TEST(ResultsJson, TheSchemaNamesNoEngine) {
  const std::string text = schema().dump();
  for (const char* name : {"\"reference\"", "realtime", "rigid", "paper", "real time"})
    EXPECT_EQ(text.find(name), std::string::npos) << name;
}

TEST(ResultsJson, WritesNanAsNullWithAText) {
  const json judgement = claim(json::parse(results_json(sample_result())), 1, 0)["judgements"][1];
  EXPECT_TRUE(judgement["value"].is_null());
  EXPECT_EQ(judgement["value_text"], "nan");
  EXPECT_EQ(judgement["passes"], false);
  EXPECT_TRUE(judgement["slack"].is_null());
}

TEST(ResultsJson, WritesInfinitiesInListsWithTheirPlace) {
  compare::SuiteResult result = sample_result();
  result.cases[0].runs[0].curve.engines[1].second[3] = -std::numeric_limits<double>::infinity();
  const json document = json::parse(results_json(result)), curve = document["cases"][0]["runs"][0]["curve"];
  EXPECT_TRUE(curve["engines"]["fast"][3].is_null());
  EXPECT_EQ(curve["engines"]["fast_text"], json({{"3", "-inf"}}));
  EXPECT_EQ(schema_fault(document, schema(), schema()), "");
}

TEST(ResultsJson, WhatWasNotAskedSaysWhy) {
  const json judgement = claim(json::parse(results_json(sample_result())), 1, 1)["judgements"][1];
  EXPECT_EQ(judgement["state"], "not asked");
  EXPECT_EQ(judgement["why"], "it would ring");
  EXPECT_FALSE(judgement.contains("passes"));
}

TEST(ResultsJson, TimesStandApart) {
  compare::SuiteResult result = sample_result();
  const std::string before = results_json(result), times = times_json(result);
  result.seconds = 99;
  result.occasion["finished"] = "another day";
  result.cases[0].runs[0].plays[1].seconds = 7;
  EXPECT_EQ(results_json(result), before);
  EXPECT_NE(times_json(result), times);
}

TEST(ResultsJson, NumbersRoundTrip) {
  compare::SuiteResult result = sample_result();
  const double awkward = 0.1 + 0.2;  // needs 17 digits
  result.cases[0].runs[0].claims[0].claim.truth = awkward;
  EXPECT_EQ(claim(json::parse(results_json(result)), 0, 0)["truth"].get<double>(), awkward);
}

TEST(ResultsJson, SlackIsLimitOverMeasured) {
  const json gate = claim(json::parse(results_json(sample_result())), 1, 0)["judgements"][0];
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
