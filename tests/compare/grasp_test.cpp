// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measure/grasp.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "cases/catalogue/builders/scenes.hpp"

namespace handhold::compare {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int frames = 10;
constexpr double dt = 0.1;

/// Two fingers and the palm at rest, 0.2 kg, let go by the support at t = 0.3 s. No field: nothing is simulated here.
Scene scene() {
  Scene scene;
  scene.duration = frames * dt;
  scene.bodies.resize(1);
  scene.bodies[0].inertia.mass = 0.2;
  scene.bodies[0].held_until = 0.3;
  const auto still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  scene.hands = {catalogue::hand_of({catalogue::palm_patch({}, still)}, scene.duration)};
  return scene;
}

ContactState sample(int phalanx, int number, Mode mode) {
  ContactState c;
  c.id = {0, std::uint8_t(phalanx), 0, std::uint8_t(number)};
  c.mode = mode;
  c.depth = 0.001 * (phalanx + 1);
  return c;
}

/// A body at rest with one sticking sample of phalanx 2 and one of phalanx 5, in every frame.
Recording resting() {
  Recording r;
  r.engine = "by hand";
  for (int i = 0; i <= frames; ++i) {
    Frame f{.t = i * dt, .bodies = {BodyState{}}};
    f.contacts = {sample(2, 0, Mode::stick), sample(5, 0, Mode::stick)};
    r.frames.push_back(f);
  }
  return r;
}

void let_go(Frame& frame) {
  for (ContactState& c : frame.contacts) c.mode = Mode::apart;
}

TEST(Grasp, IsHeldWhenTheObjectStaysInTheHand) {
  const GraspSummary s = summarize(scene(), resting());
  EXPECT_EQ(s.hold, Hold::held);
  EXPECT_EQ(s.engine, "by hand");
  EXPECT_EQ(s.phalanges_in_contact, 2);
  EXPECT_EQ(s.max_depth, 0.006);  // phalanx 5
  EXPECT_EQ(s.drift, 0);
  EXPECT_EQ(s.slip_distance, 0);
  EXPECT_FALSE(s.dropped_at);
}

TEST(Grasp, CountsEventsByKind) {
  Recording r = resting();
  for (const EventKind kind : {EventKind::touch, EventKind::touch, EventKind::breakaway, EventKind::restick,
                               EventKind::touch, EventKind::release, EventKind::breakaway})
    r.events.push_back({.t = 0.1, .kind = kind});
  const GraspSummary s = summarize(scene(), r);
  EXPECT_EQ(s.touches, 3);
  EXPECT_EQ(s.breakaways, 2);
  EXPECT_EQ(s.resticks, 1);
  EXPECT_EQ(s.releases, 1);
}

/// The line between held and slipped: 2 mm + m g / (k n) = 2 mm + 0.2 · 9.81 / (100 · 2) m = 11.81 mm. Drift counts
/// from the release of the support, not from the start.
TEST(Grasp, SlipsBeyondTwoMillimetresAndTheElasticLag) {
  for (const auto& [drift, hold] : {std::pair{0.01180, Hold::held}, std::pair{0.01182, Hold::slipped}}) {
    Recording r = resting();
    for (Frame& f : r.frames) f.bodies[0].X_WO.p.z() = f.t < 0.25 ? 1 : 0;  // carried about by the support
    r.frames.back().bodies[0].X_WO.p.z() = -drift;
    const GraspSummary s = summarize(scene(), r);
    EXPECT_EQ(s.hold, hold) << drift;
    EXPECT_NEAR(s.drift, drift, 1e-15);
  }
}

/// Drift is of the centre of mass: a turn about it is none.
TEST(Grasp, DriftIsOfTheCentreOfMass) {
  Scene turned = scene();
  turned.bodies[0].inertia.center = {0.1, 0, 0};
  Recording r = resting();
  r.frames.back().bodies[0].X_WO = {Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ())), {0.2, 0, 0}};
  EXPECT_NEAR(summarize(turned, r).drift, 0, 1e-15);
}

TEST(Grasp, IsDroppedWhenContactIsLostForGood) {
  Recording r = resting();
  let_go(r.frames[5]);  // lost and found again
  let_go(r.frames[8]);
  let_go(r.frames[9]);
  let_go(r.frames[10]);
  const GraspSummary s = summarize(scene(), r);
  EXPECT_EQ(s.hold, Hold::dropped);
  ASSERT_TRUE(s.dropped_at);
  EXPECT_DOUBLE_EQ(*s.dropped_at, 0.8);
}

TEST(Grasp, LostAndFoundAgainIsNotDropped) {
  Recording r = resting();
  let_go(r.frames[5]);
  const GraspSummary s = summarize(scene(), r);
  EXPECT_EQ(s.hold, Hold::held);
  EXPECT_FALSE(s.dropped_at);
}

TEST(Grasp, IsNotDroppedWhileTheSupportHoldsIt) {
  Scene supported = scene();
  supported.bodies[0].held_until = 99;
  EXPECT_EQ(summarize(supported, resting()).hold, Hold::held);
}

TEST(Grasp, WasNeverTouchedWithoutContact) {
  Recording r = resting();
  for (Frame& f : r.frames) let_go(f);
  const GraspSummary s = summarize(scene(), r);
  EXPECT_EQ(s.hold, Hold::never_touched);
  EXPECT_EQ(s.phalanges_in_contact, 0);
  EXPECT_EQ(s.max_depth, 0);  // samples apart have no depth
  EXPECT_FALSE(s.dropped_at);
  EXPECT_EQ(summarize(scene(), {}).hold, Hold::never_touched);
}

/// Anchors go 3 mm (sample 0) and 1 + 4 mm forth and back (sample 1); the body itself moves by a metre, which is no
/// slip.
TEST(Grasp, LongestSlipIsAPathOnTheObject) {
  Recording r = resting();
  const Pose moved{Eigen::Quaterniond(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitY())), {1, 0, 0}};
  for (std::size_t i = 0; i < r.frames.size(); ++i) {
    Frame& f = r.frames[i];
    f.bodies[0].X_WO = i < 4 ? Pose{} : moved;
    const double first = i < 5 ? 0 : 0.003;
    const double second = i < 2 ? 0 : i < 6 ? 0.001 : -0.003;
    f.contacts[0].C_W = f.bodies[0].X_WO * Eigen::Vector3d(0, first, 0);
    f.contacts[1].C_W = f.bodies[0].X_WO * Eigen::Vector3d(0, second, 0);
    for (ContactState& c : f.contacts) c.mode = Mode::slip;
  }
  EXPECT_NEAR(summarize(scene(), r).slip_distance, 0.005, 1e-15);
}

/// Apart, an anchor follows its sample freely, and a patch that comes back is another one.
TEST(Grasp, WhatAnAnchorGoesApartIsNoSlip) {
  Recording r = resting();
  for (std::size_t i = 0; i < r.frames.size(); ++i) {
    for (ContactState& c : r.frames[i].contacts) {
      c.mode = Mode::slip;
      c.C_W.x() = i < 4 ? 0.001 * double(i) : 0.5 + 0.001 * double(i);  // 3 mm, away and elsewhere, then 5 mm
    }
  }
  let_go(r.frames[4]);             // of one sample seen apart
  r.frames[4].contacts.resize(1);  // of the other not seen at all
  EXPECT_NEAR(summarize(scene(), r).slip_distance, 0.008, 1e-15);
}

TEST(Grasp, EnergyUnexplainedIsTheLargestStepOutOfTheBook) {
  Recording r = resting();
  for (Frame& f : r.frames) f.energy = {1, 2, 3, 4, 0.5};
  r.frames[3].energy = {0, 4, 2, 4.5, 1};      // balanced: 10.5 − 1 = 9.5, as before
  r.frames[6].energy.dissipated = 4 - 0.25;    // 0.25 J lost
  r.frames[7].energy.hand_work = 0.5 - 0.125;  // 0.125 J from nowhere
  EXPECT_DOUBLE_EQ(summarize(scene(), r).energy_unexplained, 0.25);
  r.frames[8].energy.elastic = nan;
  EXPECT_TRUE(std::isnan(summarize(scene(), r).energy_unexplained));  // never hidden by a maximum
}

TEST(Difference, CountsModesOfSamplesThatBothHave) {
  Recording a = resting(), b = resting();
  for (int i = 0; i < 5; ++i) b.frames[std::size_t(i)].contacts[0].mode = Mode::slip;
  b.frames.back().contacts.pop_back();
  EXPECT_DOUBLE_EQ(difference(a, b).mode_agreement, 16.0 / 21);  // 11 frames of 2 samples, one missing, 5 other
}

TEST(Difference, TakesTranslationAndRotationApart) {
  Recording a = resting(), b = resting();
  b.frames[4].bodies[0].X_WO = {Eigen::Quaterniond(Eigen::AngleAxisd(0.25, Eigen::Vector3d::UnitX())), {0, 0.0009, 0}};
  const Difference d = difference(a, b);
  EXPECT_NEAR(d.max_rotation, 0.25, 1e-14);
  EXPECT_DOUBLE_EQ(d.max_translation, 0.0009);
  EXPECT_DOUBLE_EQ(d.rms_translation, 0.0009 / std::sqrt(11.0));
  EXPECT_TRUE(std::isnan(d.first_divergence));  // never by more than a millimetre
}

TEST(Difference, IsOfTheFramesThatBothHave) {
  Recording a = resting(), b = resting();
  for (Frame& f : b.frames) f.t += 0.05;  // between the frames of a
  b.frames[3].t = 0.7;
  b.frames[3].bodies[0].X_WO.p.x() = 0.5;
  b.frames.resize(4);
  EXPECT_DOUBLE_EQ(difference(a, b).rms_translation, 0.5);
  b.frames.resize(3);
  EXPECT_TRUE(std::isnan(difference(a, b).max_translation));  // none shared: not "no difference"
}

TEST(Difference, KeepsNotANumber) {
  Recording a = resting(), b = resting();
  b.frames[4].bodies[0].X_WO.p.x() = nan;
  const Difference d = difference(a, b);
  EXPECT_TRUE(std::isnan(d.max_translation));
  EXPECT_DOUBLE_EQ(d.first_divergence, a.frames[4].t);
}

}  // namespace
}  // namespace handhold::compare
