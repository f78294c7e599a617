// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"
#include "compare/engine/engines.hpp"
#include "compare/judge/gate.hpp"
#include "compare/judge/suite.hpp"
#include "compare/judge/verdict.hpp"
#include "compare/measure/grasp.hpp"
#include "compare/measure/measure.hpp"
#include "compare/measure/timing.hpp"
#include "compare/study/convergence.hpp"

namespace handhold::compare {
namespace {

using catalogue::Measure;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(ObservedOrder, IsTwoForAnErrorThatFallsAsDtSquared) {
  const std::vector<double> dt{1e-2, 5e-3, 2.5e-3, 1.25e-3};
  std::vector<double> error;
  for (const double h : dt) error.push_back(3 * h * h);
  const auto [slope, standard_error] = observed_order(dt, error);
  EXPECT_NEAR(slope, 2, 1e-12);
  EXPECT_NEAR(standard_error, 0, 1e-12);
}

TEST(ObservedOrder, IsNanWhereThereIsNoOrder) {
  EXPECT_TRUE(std::isnan(observed_order({1, 2}, {1, 2}).slope));
  EXPECT_TRUE(std::isnan(observed_order({1, 2, 3}, {1, 0, 3}).slope));
  EXPECT_TRUE(std::isnan(observed_order({1, 2, 3}, {1, nan, 3}).slope));
}

TEST(Gate, FailsOnNan) {
  EXPECT_FALSE(passes({.quantity = "x", .measured = nan, .limit = 1}));
  EXPECT_FALSE(passes({.quantity = "x", .measured = 1, .limit = nan}));
}

TEST(Gate, SaysWhyItFailed) {
  const Gate gate{.quantity = "slip distance error", .measured = 8.3e-3, .limit = 5e-3, .unit = "m"};
  EXPECT_EQ(sentence(gate), "slip distance error 0.0083 m > 0.005 m");
}

TEST(Gate, IsVacuousWhenItCouldBeAHundredTimesTighter) {
  EXPECT_TRUE(is_vacuous({.quantity = "x", .measured = 1e-5, .limit = 2e-3}));
  EXPECT_FALSE(is_vacuous({.quantity = "x", .measured = 1e-4, .limit = 2e-3}));
  EXPECT_FALSE(is_vacuous({.quantity = "x", .measured = 0, .limit = 0}));
  EXPECT_FALSE(is_vacuous({.quantity = "x", .measured = 0, .limit = 1e-15, .rounding = 1e-16}));  // as good as can be
  EXPECT_FALSE(is_vacuous({.quantity = "x", .measured = 3e-3, .limit = 2e-3}));                   // failed, not idle
}

TEST(FrameTimes, ArePercentilesOfTheSortedTimes) {
  std::vector<double> times;
  for (int i = 100; i >= 0; --i) times.push_back(i);
  const FrameTimes t = frame_times(times);
  EXPECT_DOUBLE_EQ(t.p50, 50);
  EXPECT_DOUBLE_EQ(t.p99, 99);
  EXPECT_DOUBLE_EQ(t.max, 100);
  EXPECT_EQ(frame_times({}).frames, 0U);
}

/// A body pulled along x at 2 m/s² and spinning, recorded every 0.1 s, no hand: measures have exact answers.
Recording pulled() {
  Recording r;
  for (int i = 0; i <= 10; ++i) {
    const double t = 0.1 * i;
    Frame f{.t = t, .bodies = {BodyState{}}};
    f.bodies[0].X_WO.p.x() = t * t;
    f.bodies[0].V_WO.v.x() = 2 * t;
    f.bodies[0].X_WO.R = Eigen::AngleAxisd(8 * t, Eigen::Vector3d::UnitX());  // more than a turn in all
    r.frames.push_back(f);
  }
  Event event{.t = 0.25, .kind = EventKind::restick};
  event.body.X_WO.p.x() = 0.0625;
  event.body.X_WO.R = Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitX());
  r.events.push_back(event);
  return r;
}

Scene lone_body() {
  Scene scene;
  scene.bodies.resize(1);
  return scene;
}

TEST(Measure, InterpolatesConstantAccelerationExactly) {
  const auto at = [](Measure::Kind kind, double t) { return measure(lone_body(), pulled(), {.kind = kind, .at = t}); };
  EXPECT_NEAR(at(Measure::Kind::displacement, 0.537), 0.537 * 0.537, 1e-15);
  EXPECT_NEAR(at(Measure::Kind::speed, 0.537), 2 * 0.537, 1e-14);
  EXPECT_TRUE(std::isnan(at(Measure::Kind::displacement, 1.5)));
}

TEST(Measure, FindsTimesAndEvents) {
  const Scene scene = lone_body();
  EXPECT_NEAR(measure(scene, pulled(), {.kind = Measure::Kind::time_at_displacement, .level = 0.3}), std::sqrt(0.3),
              1e-14);
  EXPECT_EQ(measure(scene, pulled(), {.kind = Measure::Kind::event_time, .event = EventKind::restick}), 0.25);
  EXPECT_TRUE(std::isnan(measure(scene, pulled(), {.kind = Measure::Kind::event_time, .event = EventKind::breakaway})));
  EXPECT_NEAR(measure(scene, pulled(), {.kind = Measure::Kind::displacement, .event = EventKind::restick}), 0.0625,
              1e-15);
  EXPECT_EQ(measure(scene, pulled(), {.kind = Measure::Kind::no_event, .event = EventKind::release}), 1);
}

TEST(Measure, UnwrapsRotation) {
  EXPECT_NEAR(measure(lone_body(), pulled(), {.kind = Measure::Kind::rotation, .at = 1.0}), 8, 1e-12);
  EXPECT_NEAR(measure(lone_body(), pulled(), {.kind = Measure::Kind::rotation, .event = EventKind::restick}), 2, 1e-12);
}

TEST(Measure, ReadsSpinModesAndTheEnergyLedger) {
  Recording r;
  r.frames.resize(2);
  r.frames[1].t = 0.5;
  for (Frame& frame : r.frames) frame.bodies.resize(1);
  r.frames[1].bodies[0].V_WO.w = {1, 2, 3};
  r.frames[1].contacts = {{.id = {.phalanx = 1}, .mode = Mode::slip}};
  r.frames[1].energy = {.kinetic = 3, .dissipated = 0.25, .hand_work = 3.5};
  r.events = {{.t = 0.1, .kind = EventKind::touch, .id = {.phalanx = 0}},
              {.t = 0.2, .kind = EventKind::touch, .id = {.phalanx = 1}}};
  r.events[1].body.V_WO.w = {0, 0, 7};
  const Problem problem = RigidProblem{};
  const auto read = [&](const Measure& what) { return measure(problem, r, what); };
  EXPECT_EQ(read({.kind = Measure::Kind::spin, .axis = {0, 1, 0}, .at = 0.5}), 2);
  EXPECT_TRUE(std::isnan(read({.kind = Measure::Kind::spin, .axis = {0, 1, 0}, .at = 0.3})));  // no frame
  EXPECT_EQ(read({.kind = Measure::Kind::spin, .occurrence = 2, .axis = {0, 0, 1}}), 7);
  EXPECT_EQ(read({.kind = Measure::Kind::mode, .at = 0.5, .phalanx = 1}), 2);
  EXPECT_EQ(read({.kind = Measure::Kind::mode, .at = 0.5, .phalanx = 0}), 0);
  EXPECT_EQ(read({.kind = Measure::Kind::energy_residual}), 0.25);
  EXPECT_EQ(read({.kind = Measure::Kind::event_time, .phalanx = 1}), 0.2);
  EXPECT_EQ(read({.kind = Measure::Kind::event_count, .phalanx = 0}), 1);
}

TEST(Measure, HoldsOnlyBelowItsLevel) {
  EXPECT_EQ(measure(lone_body(), pulled(), {.kind = Measure::Kind::held, .level = 1.01}), 1);
  EXPECT_EQ(measure(lone_body(), pulled(), {.kind = Measure::Kind::held, .level = 0.99}), 0);
}

TEST(Measure, GivesNothingForARunThatDidNotEnd) {
  Recording broken = pulled();
  broken.outcome = Outcome::stalled;
  EXPECT_TRUE(std::isnan(measure(lone_body(), broken, {.kind = Measure::Kind::held, .level = 9})));
}

TEST(Difference, SeesWhereTwoRecordingsPart) {
  Recording a = pulled(), b = pulled();
  b.frames[7].bodies[0].X_WO.p.y() = 0.004;
  const Difference d = difference(a, b);
  EXPECT_DOUBLE_EQ(d.max_translation, 0.004);
  EXPECT_DOUBLE_EQ(d.first_divergence, a.frames[7].t);
  EXPECT_EQ(difference(a, a).max_translation, 0);
}

/// An engine that gives back what it is told: lets the suite be judged without physics.
class Oracle : public Engine {
 public:
  explicit Oracle(double slowness) : slowness_(slowness) {}
  [[nodiscard]] EngineInfo info(const EngineOptions& options) const override {
    return {.name = "oracle",
            .levels = {Level::compliant},
            .errs = {ErrorModel::Kind::controlled, options.accuracy, 0},
            .records = {true, true, true, true}};
  }
  [[nodiscard]] Recording play(const Problem& problem, const EngineOptions& options, const Progress&) const override {
    const auto& scene = std::get<Scene>(problem);
    Recording r;
    const double a = 9.81 * (std::sin(0.5) - 0.4 * std::cos(0.5)) * slowness_;  // C01
    const auto frames = std::lround(scene.duration * options.frame_rate);
    for (long i = 0; i <= frames; ++i) {
      Frame f{.t = double(i) / options.frame_rate, .bodies = {BodyState{scene.bodies[0].X_WO, {}}}};
      f.bodies[0].X_WO.p.x() += 0.5 * a * f.t * f.t;
      f.bodies[0].V_WO.v.x() = a * f.t;
      r.frames.push_back(f);
    }
    return r;
  }

 private:
  double slowness_;
};

std::size_t failures(const SuiteResult& result) { return count(result).failed; }

TEST(Suite, PassesTheTruthAndFailsWhatIsOffByAThousandth) {
  // The first run of C01 alone speaks of sliding; the two threshold runs slide as well and so one of them must fail.
  const SuiteOptions options{.ids = {"C01"}, .study_refinements = {}, .variants = false};
  const Oracle right(1), slow(1.001);
  EXPECT_EQ(failures(run_suite({&right}, options)), 1U);
  EXPECT_EQ(failures(run_suite({&right, &slow}, options)), 5U);  // twice that, and three quantities at 1e-9
}

TEST(Suite, NamesTheCasesWhenAskedForAnUnknownOne) {
  const Oracle oracle(1);
  try {
    (void)run_suite({&oracle}, {.ids = {"Z99"}});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("there are A01, "), std::string::npos) << error.what();
  }
}

TEST(Suite, NeedsAnEngine) { EXPECT_THROW((void)run_suite({}, {.ids = {"C01"}}), InputError); }

/// Joins with a name and two functions; the suite needs to know nothing more of it.
class Foreign : public Oracle {
 public:
  using Oracle::Oracle;
  [[nodiscard]] EngineInfo info(const EngineOptions&) const override {
    return {.name = "foreign", .levels = {Level::compliant}};
  }
};

TEST(Suite, GradesAForeignEngineAndFailsNothingForIt) {
  const Foreign off(1.004);
  const SuiteResult result = run_suite({&off}, {.ids = {"C01"}, .study_refinements = {}, .variants = false});
  EXPECT_EQ(count(result).gates, 0U);
  EXPECT_FALSE(passed(result));  // nothing was gated, and nothing judged is no pass
  const std::vector<ClaimResult>& slides = result.cases.at(0).runs.at(0).claims;
  EXPECT_EQ(slides.at(1).judgements.at(0).grade, Grade::within_1_percent);  // speed goes with the acceleration
  EXPECT_EQ(result.cases[0].runs[1].claims.at(0).judgements.at(0).grade,
            Grade::wrong);  // it slides below the threshold
}

TEST(Engines, RefuseAFrameRateThatIsNone) {
  const catalogue::Run& run = catalogue::all_cases().front().runs.front();
  for (const double rate : {0.0, -90.0, nan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW((void)make_engine("realtime")->play(run.problem(), {.frame_rate = rate}), InputError) << rate;
}

TEST(Engines, AreFoundByName) {
  EXPECT_EQ(make_engine("realtime")->info({}).name, "realtime");
  EXPECT_THROW((void)make_engine("bullet"), InputError);
}

}  // namespace
}  // namespace handhold::compare
