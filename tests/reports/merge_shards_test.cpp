// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/merge_shards.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"
#include "compare/engine/engines.hpp"
#include "compare/judge/suite.hpp"
#include "reports/data/results_json.hpp"

namespace handhold::reports {
namespace {

/// What a suite of three cases gives; too coarse a step, so that gates fail. `part` none: all of it.
compare::SuiteResult played(std::optional<compare::Shard> part, int substeps = 1) {
  const auto engine = compare::make_engine("realtime");
  compare::SuiteOptions options;
  options.ids = {"C01", "C06", "D13"};
  options.engine.substeps = substeps;
  options.study_refinements.clear();
  options.shard = part;
  return compare::run_suite({engine.get()}, options);
}

std::vector<NamedReport> parts_of(std::size_t count, int substeps = 1) {
  std::vector<NamedReport> parts;
  for (std::size_t i = 1; i <= count; ++i)
    parts.push_back({"part " + std::to_string(i), stored_report(played(compare::Shard{i, count}, substeps))});
  return parts;
}

std::string error_of(const std::vector<NamedReport>& parts) {
  try {
    (void)merged_shards(parts);
  } catch (const InputError& error) {
    return error.what();
  }
  return "merged";
}

TEST(MergeShards, GivesTheBytesOfOneRunInAnyOrder) {
  const std::string whole = results_json(played({}));
  ASSERT_NE(whole.find("\"passed\": false"), std::string::npos);  // so that the first failure is among the bytes
  std::mt19937 random(7);
  for (const std::size_t count : {1u, 2u, 7u, 64u}) {
    std::vector<NamedReport> parts = parts_of(count);
    std::ranges::shuffle(parts, random);
    EXPECT_EQ(merged_shards(parts).results, whole) << count;
  }
}

TEST(MergeShards, RefusesWhatIsNoWholeSuite) {
  const std::vector<NamedReport> parts = parts_of(3);
  EXPECT_NE(error_of({parts[0], parts[2]}).find("part 2 of 3 is missing (handhold suite --shard 2/3)"),
            std::string::npos);
  EXPECT_NE(error_of({parts[0], parts[1]}).find("part 3 of 3 is missing"), std::string::npos);
  EXPECT_NE(error_of({parts[0], parts[1], parts[1], parts[2]}).find("are both part 2 of 3"), std::string::npos);
  EXPECT_NE(error_of({parts[0], parts_of(2)[1]}).find("a part of 3"), std::string::npos);
  EXPECT_NE(error_of({parts[0], parts_of(3, 2)[1], parts[2]}).find("differ in their engines"), std::string::npos);
  EXPECT_NE(error_of({{"whole", stored_report(played({}))}}).find("whole: is no part"), std::string::npos);
  EXPECT_NE(error_of({}).find("none are given"), std::string::npos);
}

TEST(MergeShards, RefusesAPartThatWasInterrupted) {
  compare::SuiteResult cut = played(compare::Shard{1, 2});
  cut.cases.pop_back();
  EXPECT_NE(error_of({{"a", stored_report(cut)}, {"b", stored_report(played(compare::Shard{2, 2}))}})
                .find("it was interrupted: play it again with --shard 1/2"),
            std::string::npos);
}

}  // namespace
}  // namespace handhold::reports
