// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/baseline_file.hpp"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"
#include "compare/judge/verdict.hpp"
#include "reports/data/results_json.hpp"
#include "reports/data/write_report.hpp"
#include "tests/reports/sample_result.hpp"

namespace handhold::reports {
namespace {

compare::Baseline sample() { return baseline_of(results_json(sample_result()), "sample"); }

BaselineFile through_a_file(const std::string& text) {
  const std::filesystem::path path = testing::TempDir() + "handhold_baseline_file_test.json";
  write_file(path, text);
  return read_baseline(path);
}

TEST(BaselineFile, KnowsEveryGateOfAReport) {
  const compare::Baseline gates = sample();
  EXPECT_EQ(gates.size(), compare::count(sample_result()).gates);  // also the order study, not what nobody asked
  const compare::Measured& late = gates.at({"C01", "slides", "slip onset", "fast"});
  EXPECT_EQ(late.value, 0.2031);
  EXPECT_EQ(late.truth, 0.2);
  EXPECT_EQ(late.limit, 2.8e-3);
  EXPECT_TRUE(std::isnan(gates.at({"D02", "holds at 0.98", "stop time", "fast"}).value));
  const compare::Measured& order = gates.at({"C01", "slides", "slip distance", "fast", true});
  EXPECT_NEAR(order.value, 0.01, 1e-15);
  EXPECT_EQ(order.uncertainty, 0.02);
}

TEST(BaselineFile, IsReadAsItWasWritten) {
  const BaselineFile read = through_a_file(to_json({sample(), {"the first \"one\"", "another"}}));
  EXPECT_EQ(read.reasons, (std::vector<std::string>{"the first \"one\"", "another"}));
  EXPECT_EQ(read.gates.size(), sample().size());
  EXPECT_TRUE(compare::changes(read.gates, sample()).empty());
  EXPECT_TRUE(compare::changes(sample(), read.gates).empty());
  EXPECT_EQ(to_json(read), to_json({sample(), read.reasons}));
}

TEST(BaselineFile, HasAClaimALine) {  // so that a difference of two versions can be read
  const std::string text = to_json({sample(), {}});
  const std::size_t begin = text.find("\n  \"slip onset\": {\"truth\":0.2,\"exact\":[");
  ASSERT_NE(begin, std::string::npos) << text;
  const std::string line = text.substr(begin + 1, text.find('\n', begin + 1) - begin - 1);
  EXPECT_NE(line.find("\"fast\":[0.2031,0.0028]"), std::string::npos) << line;
}

TEST(BaselineFile, AnEmptyOneIsOne) { EXPECT_TRUE(through_a_file(to_json({})).gates.empty()); }

TEST(BaselineFile, WhatIsNoneSaysSo) {
  for (const char* text : {"", "{}", "[1]", "{\"format\": \"handhold baseline\", \"version\": 2}",
                           "{\"format\": \"handhold baseline\", \"version\": 1, \"reasons\": [], \"cases\": {\"C01\": "
                           "{\"slides\": {\"slip\": {\"fast\": 3}}}}}"}) {
    EXPECT_THROW((void)through_a_file(text), InputError) << text;
  }
  EXPECT_THROW((void)baseline_of("{}", "x"), InputError);
}

}  // namespace
}  // namespace handhold::reports
