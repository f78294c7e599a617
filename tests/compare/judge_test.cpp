// SPDX-License-Identifier: GPL-3.0-or-later
// What guards the judge itself: which limit applies, what an error is, what a suite must have run.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cases/catalogue/case.hpp"
#include "compare/engine/engines.hpp"
#include "compare/judge/suite.hpp"
#include "compare/judge/verdict.hpp"
#include "compare/measure/measure.hpp"

namespace handhold::compare {
namespace {

using catalogue::Claim;
using catalogue::Measure;

const EngineInfo controlled{.name = "c", .errs = {ErrorModel::Kind::controlled, 1e-8, 0}};
const EngineInfo stepped{.name = "s", .errs = {ErrorModel::Kind::stepped, 0, 0.01}};

Claim claim(bool relative) {
  Claim c{.quantity = "way", .unit = "m", .truth = 2};
  c.controlled = {.value = 1e-6, .per_accuracy = 10, .per_step = 7, .relative = relative, .reason = "a"};
  c.stepped = {.value = 1e-3, .per_accuracy = 9, .per_step = 0.5, .relative = relative, .reason = "b"};
  return c;
}

TEST(Judge, TakesTheLimitOfTheEnginesOwnErrors) {
  EXPECT_DOUBLE_EQ(judge(claim(false), controlled, 2).gate->limit, 1e-6 + 1e-7);
  EXPECT_DOUBLE_EQ(judge(claim(false), stepped, 2).gate->limit, 1e-3 + 5e-3);
  EXPECT_EQ(judge(claim(false), stepped, 2).gate->reason, "b");
}

/// A force that follows the gap takes the state's error twice times the rate of recovery; what does not hang on the
/// state is as it is.
TEST(Judge, LetsALimitFollowWhatAMethodErrsBy) {
  const ErrorModel errs{.kind = ErrorModel::Kind::controlled,
                        .accuracy = 1,
                        .step = 2,
                        .noise = 3,
                        .delay = 5,
                        .recovery = 10,
                        .rounding = 7};
  catalogue::Limit limit{
      .value = 1e6, .per_accuracy = 1, .per_noise = 1, .per_rounding = 1, .per_step = 1e3, .per_delay = 1e3};
  EXPECT_DOUBLE_EQ(limit_value(limit, errs), 1e6 + 2e3 + 5e3 + 11);
  limit.recoveries = 2;
  EXPECT_DOUBLE_EQ(limit_value(limit, errs), 1e6 + 2e3 + 5e3 + 1100);
}

TEST(Judge, MeasuresAShareOfTheTruthWhereTheLimitIsOne) {
  EXPECT_DOUBLE_EQ(judge(claim(false), stepped, 2.5).error, 0.5);
  EXPECT_DOUBLE_EQ(judge(claim(true), stepped, 2.5).error, 0.25);
  EXPECT_DOUBLE_EQ(judge(claim(true), stepped, 2.5).gate->measured, 0.25);
  EXPECT_EQ(judge(claim(true), stepped, 2.5).gate->unit, "");
}

/// The step is that of a sub-step, whatever the frame.
TEST(Judge, KnowsAnEnginesStepFromItsOptions) {
  const auto step = [](const EngineOptions& options) { return make_engine("realtime")->info(options).errs.step; };
  EXPECT_DOUBLE_EQ(step({.frame_rate = 60, .substeps = 2}), 1.0 / 120);
  EXPECT_DOUBLE_EQ(step({.frame_rate = 60, .substeps = 5}), 1.0 / 300);
}

/// Turns by 1.9 rad a frame, more than a quarter and less than half a turn.
TEST(Measures, UnwrapTurnsOfMoreThanAQuarterAFrame) {
  Scene scene;
  scene.bodies.resize(1);
  Recording r;
  for (int i = 0; i <= 10; ++i) {
    r.frames.push_back({.t = 0.1 * i, .bodies = {BodyState{}}});
    r.frames.back().bodies[0].X_WO.R = Eigen::AngleAxisd(1.9 * i, Eigen::Vector3d::UnitZ());
  }
  const Measure turned{.kind = Measure::Kind::rotation, .axis = Eigen::Vector3d::UnitZ(), .at = 1.0};
  EXPECT_NEAR(measure(scene, r, turned), 19, 1e-12);
}

/// 100 mm out and back again is no hold, and just beyond the level neither.
TEST(Measures, HoldsOnlyWhatNeverSlid) {
  Scene scene;
  scene.bodies.resize(1);
  Recording r;
  for (const double x : {0.0, 0.1, 0.0}) {
    r.frames.push_back({.t = 0.1 * double(r.frames.size()), .bodies = {BodyState{}}});
    r.frames.back().bodies[0].X_WO.p.x() = x;
  }
  const auto held = [&](double level) { return measure(scene, r, {.kind = Measure::Kind::held, .level = level}); };
  EXPECT_EQ(held(0.002), 0);
  EXPECT_EQ(held(0.0999), 0);
  EXPECT_EQ(held(0.1001), 1);
}

/// Two bodies; the second moves, and its samples touch the first.
class TwoBodies : public ::testing::Test {
 protected:
  TwoBodies() {
    scene_.bodies.resize(2);
    scene_.bodies[1].samples_O.resize(3);
    for (int i = 0; i <= 2; ++i) {
      Frame f{.t = 0.5 * i, .bodies = {BodyState{}, BodyState{}}};
      f.bodies[1].X_WO.p.x() = i;
      f.contacts = {{.id = {.body = 0, .sample = 0}, .f_W = {7, 0, 0}}};  // of a hand
      for (int k = 0; k < 3; ++k)
        f.contacts.push_back({.id = {SampleId::of_body, 1, 0, std::uint8_t(k)}, .f_W = {1.0 + k, 0, 0}});
      recording_.frames.push_back(f);
    }
    recording_.events = {{.t = 0.1, .kind = EventKind::touch, .id = {.body = 0, .sample = 0}},
                         {.t = 0.2, .kind = EventKind::touch, .id = {SampleId::of_body, 1, 0, 2}},
                         {.t = 0.3, .kind = EventKind::touch, .id = {.body = 1, .sample = 0}}};
  }
  [[nodiscard]] double read(Measure what) const { return measure(scene_, recording_, what); }

  Scene scene_{};
  Recording recording_{};
};

TEST_F(TwoBodies, AreToldApart) {
  EXPECT_EQ(read({.kind = Measure::Kind::displacement, .at = 1.0, .body = 0}), 0);
  EXPECT_EQ(read({.kind = Measure::Kind::displacement, .at = 1.0, .body = 1}), 2);
  EXPECT_EQ(read({.kind = Measure::Kind::force, .at = 1.0}), 7 + 6);
  EXPECT_EQ(read({.kind = Measure::Kind::force, .at = 1.0, .owner = 1}), 6);
  EXPECT_EQ(read({.kind = Measure::Kind::force, .at = 1.0, .phalanx = 0}), 7);
  EXPECT_EQ(read({.kind = Measure::Kind::event_time, .event = EventKind::touch, .body = 1}), 0.3);
  EXPECT_EQ(read({.kind = Measure::Kind::event_time, .event = EventKind::touch, .owner = 1}), 0.2);
  EXPECT_EQ(read({.kind = Measure::Kind::event_count, .event = EventKind::touch}), 2);
}

TEST_F(TwoBodies, CanBeCountedFromTheLast) {
  EXPECT_EQ(read({.kind = Measure::Kind::displacement, .at = 1.0, .body = 0, .from_last = true}), 2);
  EXPECT_EQ(read({.kind = Measure::Kind::force, .at = 1.0, .body = 1, .sample = 0, .owner = 0, .from_last = true}), 3);
}

/// Steps, and is never right: the suite is asked whether it asked for everything.
class Stepping : public Engine {
 public:
  [[nodiscard]] EngineInfo info(const EngineOptions& options) const override {
    return {.name = "stepping",
            .levels = {Level::compliant},
            .errs = {ErrorModel::Kind::stepped, 0, 1 / options.frame_rate},
            .records = {true, true, true, true}};
  }
  [[nodiscard]] Recording play(const Problem&, const EngineOptions&, const Progress&) const override { return {}; }
};

TEST(Suite, RunsTheLastCaseToo) {
  const Stepping engine;
  const std::string first = catalogue::all_cases().front().id, last = catalogue::all_cases().back().id;
  const SuiteResult result = run_suite({&engine}, {.ids = {first, last}, .study_refinements = {}, .variants = false});
  ASSERT_EQ(result.cases.size(), 2u);
  EXPECT_EQ(result.cases[1].id, last);
  EXPECT_EQ(result.cases[1].runs.size(),
            std::size_t(std::ranges::count_if(catalogue::all_cases().back().runs,
                                              [](const catalogue::Run& run) { return run.variant.empty(); })));
}

TEST(Suite, StudiesTheOrderWhereAClaimConverges) {
  const Stepping engine;
  const SuiteResult result = run_suite({&engine}, {.ids = {"C01"}});
  std::size_t studies = 0, converging = 0;
  for (const RunResult& run : result.cases.at(0).runs)
    for (const ClaimResult& c : run.claims) {
      studies += c.studies.size();
      converging += c.claim.converges;
      EXPECT_TRUE(run.variant.empty() || !c.claim.converges);
    }
  EXPECT_EQ(studies, converging);
  EXPECT_EQ(studies, 1u);
}

}  // namespace
}  // namespace handhold::compare
