// SPDX-License-Identifier: GPL-3.0-or-later
// The suite in one thread and in several: the same numbers, in the same order.
#include <cmath>
#include <memory>
#include <stdexcept>

#include <gtest/gtest.h>

#include "compare/engine/engines.hpp"
#include "compare/judge/suite.hpp"

namespace handhold::compare {
namespace {

SuiteResult suite(int threads) {
  const std::unique_ptr<Engine> realtime = make_engine("realtime"), grasp = make_engine("kinematic-grasp");
  return run_suite({realtime.get(), grasp.get()}, {.ids = {"A01", "C01", "C04", "D01", "D02"}, .threads = threads});
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

TEST(SuiteThreads, GiveTheSameNumbers) {
  const SuiteResult one = suite(1), two = suite(2), many = suite(7);
  for (const SuiteResult* other : {&two, &many}) {
    ASSERT_EQ(one.cases.size(), other->cases.size());
    for (std::size_t c = 0; c < one.cases.size(); ++c) {
      EXPECT_EQ(one.cases[c].id, other->cases[c].id);
      ASSERT_EQ(one.cases[c].runs.size(), other->cases[c].runs.size());
      for (std::size_t r = 0; r < one.cases[c].runs.size(); ++r) {
        const RunResult &a = one.cases[c].runs[r], &b = other->cases[c].runs[r];
        EXPECT_EQ(a.name, b.name);
        for (std::size_t i = 0; i < a.claims.size(); ++i)
          for (std::size_t e = 0; e < a.claims[i].judgements.size(); ++e)
            EXPECT_TRUE(same(a.claims[i].judgements[e].value, b.claims[i].judgements[e].value)) << a.name;
      }
    }
  }
}

TEST(SuiteThreads, AnErrorInOneReachesTheCaller) {
  class Broken : public Engine {
   public:
    [[nodiscard]] EngineInfo info(const EngineOptions&) const override {
      return {.name = "broken", .levels = {Level::compliant}};
    }
    [[nodiscard]] Recording play(const Problem&, const EngineOptions&, const Progress&) const override {
      throw std::runtime_error("out of order");
    }
  };
  const Broken broken;
  EXPECT_THROW((void)run_suite({&broken}, {.ids = {"A01", "C01", "C04"}, .threads = 3}), std::runtime_error);
}

}  // namespace
}  // namespace handhold::compare
