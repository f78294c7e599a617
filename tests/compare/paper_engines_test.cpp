// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/case.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/engines.hpp"
#include "compare/judge/suite.hpp"
#include "compare/measure/measure.hpp"

namespace handhold::compare {
namespace {

using catalogue::Measure;

/// Frame k: body at growth^k cos(k), one sample at (k, 0, 0) with an anchor 0.5 behind and the force (k, 0, 0).
Recording oscillation(double growth, int frames) {
  Recording r;
  for (int k = 0; k <= frames; ++k) {
    Frame f{.t = 0.1 * k, .bodies = {BodyState{}}};
    f.bodies[0].X_WO.p.x() = std::pow(growth, k) * std::cos(double(k));
    f.contacts = {{.id = {}, .mode = k % 2 ? Mode::slip : Mode::stick}};
    f.contacts[0].p_W.x() = k;
    f.contacts[0].C_W.x() = k - 0.5;
    f.contacts[0].f_W.x() = k;
    r.frames.push_back(f);
  }
  return r;
}

double read(const Recording& recording, const Measure& what) { return measure(PrintedProblem{}, recording, what); }

TEST(FramesMeasure, ReadsWhatFramesHold) {
  const Recording r = oscillation(1.1, 10);
  using Kind = Measure::Kind;
  EXPECT_DOUBLE_EQ(read(r, {.kind = Kind::force_sum, .at = 0.4, .from = 0.2}), 2 + 3 + 4);
  EXPECT_DOUBLE_EQ(read(r, {.kind = Kind::force_sum, .at = 0.4, .from = 0.2, .mode = Mode::slip}), 3);
  EXPECT_DOUBLE_EQ(read(r, {.kind = Kind::mode_count, .at = 1, .from = 0, .mode = Mode::slip}), 5);
  EXPECT_DOUBLE_EQ(read(r, {.kind = Kind::mode_count, .at = 0.3, .mode = Mode::stick}), 0);
  EXPECT_DOUBLE_EQ(read(r, {.kind = Kind::lag, .at = 0.3}), 0.5);
  EXPECT_DOUBLE_EQ(read(r, {.kind = Kind::work, .at = 0.3, .from = 0}), -(0.5 + 1.5 + 2.5));
  EXPECT_NEAR(read(r, {.kind = Kind::growth, .at = 1, .from = 0.1}), 1.1, 1e-14);
}

TEST(FramesMeasure, IsNoNumberBetweenFrames) {
  const Recording r = oscillation(1.1, 10);
  EXPECT_TRUE(std::isnan(read(r, {.kind = Measure::Kind::force_sum, .at = 0.45, .from = 0})));
  EXPECT_TRUE(std::isnan(read(r, {.kind = Measure::Kind::force_sum, .at = 0.2, .from = 0.4})));
  EXPECT_TRUE(std::isnan(read(r, {.kind = Measure::Kind::lag, .at = 0.2, .sample = 7})));
  EXPECT_TRUE(std::isnan(read(r, {.kind = Measure::Kind::growth, .at = 0.2, .from = 0})));  // three frames say nothing
}

TEST(PaperEngine, RefusesASampleFarFromTheSurface) {
  const PrintedProblem far{.mobility = Mobility::fixed,
                           .phalanges = {{.p_P = {Eigen::Vector3d::Zero()}, .pose = [](double) {
                                            return Pose{.p = {0, 0, 1}};
                                          }}}};
  EXPECT_THROW((void)make_engine("paper")->play(far, {}), InputError);
}

/// Eq. 1 must hold on what is recorded, whichever anchor the force used.
TEST(PaperEngine, RecordsTheAnchorThatTheForceUsed) {
  for (const printed::Order order : {printed::Order::force_first, printed::Order::anchor_first}) {
    PrintedProblem p{.mobility = Mobility::fixed,
                     .phalanges = {{.p_P = {Eigen::Vector3d::Zero()},
                                    .pose =
                                        [](double t) {
                                          return Pose{.p = {0.2 * t, 0, -0.0025}};
                                        }}},
                     .frames = 30};
    p.law.order = order;
    const Recording recording = make_engine("paper")->play(p, {});
    EXPECT_EQ(recording.frames.size(), 31U);
    int slips = 0;
    for (const Frame& frame : recording.frames) {
      const ContactState& c = frame.contacts.front();
      slips += c.mode == Mode::slip;
      const double mu = c.mode == Mode::slip ? p.friction.mu_dynamic : 1;
      EXPECT_NEAR(c.f_W.x(), mu * p.law.stiffness * (c.p_W - c.C_W).x(), 1e-14);
      EXPECT_NEAR(c.f_W.z(), p.law.stiffness * (c.p_W - c.C_W).z(), 1e-14);
    }
    EXPECT_GT(slips, 20);
    EXPECT_EQ(recording.events.front().kind, EventKind::touch);
    EXPECT_EQ(recording.events.back().kind, EventKind::breakaway);
  }
}

Scene block_on_a_palm() {
  Scene scene;
  scene.bodies = {catalogue::block({catalogue::edge, catalogue::edge, catalogue::edge}, catalogue::voxel, 0.1, {})};
  scene.hands = {catalogue::hand_of(
      {catalogue::palm_patch({}, [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); })}, 1)};
  return scene;
}

TEST(PaperCoulombEngine, SaysWhatItCannotPlay) {
  const auto engine = make_engine("paper-coulomb");
  EXPECT_EQ(engine->why_not(block_on_a_palm()), "");
  Scene two = block_on_a_palm(), held = block_on_a_palm(), seeded = block_on_a_palm(), alone = block_on_a_palm();
  two.bodies.push_back(two.bodies.front());
  held.bodies.front().held_until = 0.1;
  seeded.hands.front().given.clear();
  alone.hands.clear();
  EXPECT_NE(engine->why_not(two).find("one body"), std::string::npos);
  EXPECT_NE(engine->why_not(held).find("support"), std::string::npos);
  EXPECT_NE(engine->why_not(seeded).find("given sample points"), std::string::npos);
  EXPECT_NE(engine->why_not(alone).find("hand"), std::string::npos);
}

TEST(PaperCoulombEngine, IsGradedAndSlidesDownAnInclineAsCoulombSays) {
  const auto engine = make_engine("paper-coulomb");
  const SuiteResult result = run_suite({engine.get()}, {.ids = {"C01"}});
  std::size_t right = 0;
  for (const RunResult& run : result.cases.front().runs)
    for (const ClaimResult& claim : run.claims) {
      const Judgement& j = claim.judgements.front();
      EXPECT_FALSE(j.gate.has_value());
      ASSERT_TRUE(j.grade.has_value()) << claim.claim.quantity << ": " << j.why_not;
      right += *j.grade != Grade::wrong;
    }
  EXPECT_GE(right, 4U);  // slides 5 % right at least, and holds or not at 0.98 and 1.02 of the threshold
}

}  // namespace
}  // namespace handhold::compare
