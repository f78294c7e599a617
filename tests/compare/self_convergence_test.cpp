// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/self_convergence.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace handhold::compare {
namespace {

Recording recording_of(double x, double angle, const std::vector<Event>& events) {
  Recording r;
  Frame frame{.t = 1, .bodies = {BodyState{}}};
  frame.bodies[0].X_WO = {Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())), {x, 0, 0}};
  r.frames = {frame};
  r.events = events;
  return r;
}

Event event(double t, EventKind kind, std::uint8_t sample) {
  Event e;
  e.t = t;
  e.kind = kind;
  e.id.sample = sample;
  return e;
}

TEST(Gap, MeasuresEndsAndEventsOfEachSample) {
  const std::vector<Event> one{event(0.1, EventKind::breakaway, 0), event(0.2, EventKind::restick, 0),
                               event(0.2, EventKind::breakaway, 1)};
  // The same, seen in another order of samples, one event 3 ms later.
  const std::vector<Event> other{event(0.1, EventKind::breakaway, 0), event(0.2, EventKind::breakaway, 1),
                                 event(0.203, EventKind::restick, 0)};
  const Gap g = gap(recording_of(0.5, 0.1, one), recording_of(0.502, 0.25, other));
  EXPECT_NEAR(g.position, 0.002, 1e-15);
  EXPECT_NEAR(g.rotation, 0.15, 1e-15);
  EXPECT_NEAR(g.event_time, 0.003, 1e-15);
  EXPECT_EQ(g.unlike_samples, 0);
}

TEST(Gap, CountsSamplesWhoseEventsAreOthers) {
  const std::vector<Event> one{event(0.1, EventKind::breakaway, 0), event(0.2, EventKind::breakaway, 1)};
  const std::vector<Event> other{event(0.1, EventKind::breakaway, 0), event(0.2, EventKind::restick, 1),
                                 event(0.3, EventKind::touch, 2)};
  EXPECT_EQ(gap(recording_of(0, 0, one), recording_of(0, 0, other)).unlike_samples, 2);
}

TEST(Gap, IsNotANumberWhenARunDiverged) {
  EXPECT_TRUE(std::isnan(gap(recording_of(std::nan(""), 0, {}), recording_of(0, 0, {})).position));
  EXPECT_TRUE(std::isnan(gap(Recording(), recording_of(0, 0, {})).position));
}

/// Errs by 3 accuracy^power in position, accuracy in rotation and twice that in the time of its one event; below
/// accuracy 1e-7 it sees one more event.
class Model : public Engine {
 public:
  explicit Model(double power) : power_(power) {}
  [[nodiscard]] EngineInfo info(const EngineOptions& options) const override {
    return {.name = "model",
            .levels = {Level::compliant},
            .errs = {ErrorModel::Kind::controlled, options.accuracy, 0},
            .records = {true, true, true, true}};
  }
  [[nodiscard]] Recording play(const Problem&, const EngineOptions& options, const Progress&) const override {
    const double a = options.accuracy;
    std::vector<Event> events{event(0.5 + 2 * a, EventKind::touch, 0)};
    if (a < 1e-7) events.push_back(event(0.75, EventKind::release, 0));
    Recording r = recording_of(1 + 3 * std::pow(a, power_), a, events);
    r.provenance["steps"] = "42";
    return r;
  }

 private:
  double power_;
};

// Differences to 1e-13 differ from the errors themselves by a third for the run before, else by a hundredth: the slope
// of the four is off by a few hundredths, and what it says of the tightest by a fifth.
TEST(SelfConvergence, FindsTheOrderAndTheErrorOfTheTightest) {
  const SelfConvergence study = self_convergence(Model(0.5), Scene(), reference_settings());
  ASSERT_EQ(study.runs.size(), 5U);
  EXPECT_NEAR(study.position.slope, 0.5, 0.04);
  EXPECT_NEAR(study.rotation.slope, 1, 0.02);
  EXPECT_EQ(study.runs[4].to_tightest.position, 0);
  EXPECT_NEAR(study.runs[4].error.position / (3 * std::sqrt(1e-13)), 1, 0.4);
  EXPECT_NEAR(study.runs[3].error.position / 3e-6, 1, 0.2);
  EXPECT_NEAR(study.runs[2].error.position / 3e-5, 1, 0.2);
  EXPECT_EQ(study.runs[0].steps, 42);
  EXPECT_EQ(study.runs[0].to_tightest.unlike_samples, 1);
  EXPECT_EQ(study.runs[1].to_tightest.unlike_samples, 0);
}

TEST(SelfConvergence, SaysWhichPromiseIsBroken) {
  for (const ConvergenceRun& run : self_convergence(Model(1), Scene(), reference_settings()).runs)
    EXPECT_TRUE(run.kept) << run.setting.name;
  const SelfConvergence poor = self_convergence(Model(0.5), Scene(), reference_settings());
  EXPECT_TRUE(poor.runs[0].kept);  // nothing promised
  EXPECT_FALSE(poor.runs[2].kept);
  EXPECT_FALSE(poor.runs[3].kept);
}

TEST(SelfConvergence, StopsWhenToldTo) {
  const auto before_the_third = [](const Setting& setting, double) { return setting.size > 1e-9; };
  EXPECT_EQ(self_convergence(Model(1), Scene(), reference_settings(), before_the_third).runs.size(), 2U);
}

}  // namespace
}  // namespace handhold::compare
