// SPDX-License-Identifier: GPL-3.0-or-later
// Patches that pinch or spin a cube: closed forms with several samples and rotation.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"
#include "tests/reference/scenes.hpp"

namespace handhold::reference {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using namespace testing;

const double pi = std::acos(-1.0);

/// Two fingers along y, a square of four samples each, pressed in by `depth`, moving apart at `speed`.
Scene pinch_scene(double duration, double depth, double speed) {
  Scene scene = cube_scene(duration);
  scene.gravity = {0, 0, -gravity};
  std::vector<Patch> patches;
  for (const double side : {-1.0, 1.0}) {
    Patch patch;
    patch.phalanx = side < 0 ? 2 : 5;
    for (const Vector3d& p : square(0.004)) patch.points.push_back({p.x(), 0, p.y()});
    patch.start.lag_W = {0, 0, scene.bodies[0].inertia.mass * gravity / (8 * scene.contact.stiffness)};  // carries m g
    patch.pose = [=](double t) {
      return Pose{Quaterniond::Identity(), {0, side * (half_edge - depth + speed * t), 0}};
    };
    patches.push_back(patch);
  }
  scene.hands.push_back(hand_with(patches, duration + 0.1));
  return scene;
}

// The springs stay at the load m g until mu_s N = m g / 8 a sample; then N falls linearly and m z'' = −m g + 8 mu_d k
// d(t).
TEST(Pinch, SlipsAtTheOnsetWhenItOpens) {
  const double depth = 0.004, speed = 0.02, k = 400, m = 0.2, mu_s = 0.5, mu_d = 0.4;
  const double onset = (depth - m * gravity / (8 * mu_s * k)) / speed;
  const Recording r = simulate(pinch_scene(onset + 0.03, depth, speed), {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  ASSERT_EQ(r.events.size(), 8u);
  for (const Event& event : r.events) {
    EXPECT_EQ(event.kind, EventKind::breakaway);
    EXPECT_NEAR(event.t, onset, 1e-9);
  }
  const double tau = 0.03;
  const double fall = gravity * (1 - mu_d / mu_s) * tau * tau / 2 + 8 * mu_d * k * speed / m * tau * tau * tau / 6;
  EXPECT_NEAR(r.frames.back().bodies[0].X_WO.p.z(), -fall, 1e-8);
  EXPECT_LT(energy_residual(r), 1e-8);
}

TEST(Pinch, LetsGoWhenTheFingersAreOff) {
  const double depth = 0.001, speed = 0.05, k = 400, m = 0.2;  // 8 k d mu_s < m g: outside the cone from the start
  const Recording r = simulate(pinch_scene(0.04, depth, speed), {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  ASSERT_EQ(r.events.size(), 8u);
  for (const Event& event : r.events) {
    EXPECT_EQ(event.kind, EventKind::release);
    EXPECT_NEAR(event.t, depth / speed, 2e-9);  // 0.5e-10 m of depth left at 0.05 m/s
  }
  // Impulse of friction 8 mu_d k d(t) until the release.
  const double v = -gravity * 0.04 + 8 * 0.4 * k * depth * (depth / speed) / 2 / m;
  EXPECT_NEAR(r.frames.back().bodies[0].V_WO.v.z(), v, 1e-8);
  EXPECT_LT(energy_residual(r), 1e-8);
}

/// Two rings on the axis z press the cube, which spins about it. Lags start on the pursuit curve of steady spinning.
Scene spin_scene(double duration, double radius, double spin, double damping) {
  Scene scene = cube_scene(duration);
  scene.contact = {400, damping};
  scene.bodies[0].V_WO.w = {0, 0, spin};
  const double depth = 0.002, lag = scene.bodies[0].friction.mu_dynamic * depth;
  for (const double side : {-1.0, 1.0}) {
    Hand hand;
    Patch patch;
    patch.points = ring_z(radius, 8);
    patch.pose = [=](double) { return Pose{Quaterniond::Identity(), {0, 0, side * (half_edge - depth)}}; };
    hand = hand_with({patch}, duration + 0.1);
    // The anchor runs on a circle of radius sqrt(a² − ρ²), the lag p − C is tangent to it and opposes the spin.
    const double back = std::asin(lag / radius);
    for (const Vector3d& p : patch.points) {
      const double angle = std::atan2(p.y(), p.x()) + back;
      hand.given[0].start.push_back({lag * Vector3d(std::sin(angle), -std::cos(angle), 0), true});
    }
    hand.given[0].start.erase(hand.given[0].start.begin(), hand.given[0].start.begin() + 8);
    scene.hands.push_back(hand);
  }
  return scene;
}

// Torque 2 N mu_d sqrt(a² − ρ²) of the two rings, constant until the spin stops.
TEST(Ring, StopsASpinAsThePursuitCurveSays) {
  const double a = 0.006, k = 400, depth = 0.002, mu = 0.4, spin = 3;
  const Scene scene = spin_scene(0.12, a, spin, 0);
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  const double lag = mu * depth, I = scene.bodies[0].inertia.about_center(2, 2);
  const double torque = 16 * k * depth * mu * std::sqrt(a * a - lag * lag);
  const double t_stop = I * spin / torque;
  for (const Frame& frame : r.frames) {
    if (frame.t > t_stop) break;
    const Quaterniond& R = frame.bodies[0].X_WO.R;
    EXPECT_NEAR(2 * std::atan2(R.z(), R.w()), spin * frame.t - torque / I * frame.t * frame.t / 2, 1e-8);
    EXPECT_LT(frame.bodies[0].X_WO.p.norm(), 1e-9);
  }
  ASSERT_GE(r.events.size(), 16u);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(r.events[i].kind, EventKind::restick);
    EXPECT_NEAR(r.events[i].t, t_stop, 1e-8);
  }
  EXPECT_LT(energy_residual(r), 1e-8);
}

TEST(Ring, KeepsTheEnergyBookWithDamping) {
  const Recording r = simulate(spin_scene(0.3, 0.006, 3, 0.5), {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  EXPECT_LT(energy_residual(r), 1e-8);
  for (std::size_t i = 1; i < r.frames.size(); ++i)
    EXPECT_GE(r.frames[i].energy.dissipated, r.frames[i - 1].energy.dissipated - 1e-12);
}

// An object and a hand that turn together are at rest against each other: no damper works, though the anchors, 2 mm
// from the samples, have another velocity than these.
TEST(Ring, FeelsNoDamperWhenHandAndObjectTurnTogether) {
  const double spin = 3, depth = 0.002;
  Scene scene = cube_scene(0.2);
  scene.contact = {400, 2};
  scene.bodies[0].V_WO.w = {spin, 0, 0};
  for (const double side : {-1.0, 1.0}) {
    Patch patch;
    for (const Vector3d& p : ring_z(0.006, 8)) patch.points.push_back(p + Vector3d(0, 0, side * (half_edge - depth)));
    patch.pose = [=](double t) { return Pose{Quaterniond(Eigen::AngleAxisd(spin * t, Vector3d::UnitX())), {0, 0, 0}}; };
    scene.hands.push_back(hand_with({patch}, 0.3));
  }
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  EXPECT_TRUE(r.events.empty());
  EXPECT_LT((r.frames.back().bodies[0].V_WO.w - Vector3d(spin, 0, 0)).norm(), 1e-9);
  EXPECT_LT(r.frames.back().energy.dissipated, 1e-15);  // would be 16 c (w d)² = 1e-3 W at first
  EXPECT_LT(energy_residual(r), 1e-9);
}

TEST(Run, HasTheSameBitsTwice) {
  const Scene scene = spin_scene(0.1, 0.006, 3, 0.5);
  const Recording a = simulate(scene, {}), b = simulate(scene, {});
  ASSERT_EQ(a.frames.size(), b.frames.size());
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    EXPECT_EQ(a.frames[i].bodies[0].X_WO.R.coeffs(), b.frames[i].bodies[0].X_WO.R.coeffs());
    EXPECT_EQ(a.frames[i].bodies[0].X_WO.p, b.frames[i].bodies[0].X_WO.p);
  }
  for (std::size_t i = 0; i < a.events.size(); ++i) EXPECT_EQ(a.events[i].t, b.events[i].t);
}

TEST(Run, StopsWhenTheCallerWantsAndAtItsLimit) {
  const Scene scene = palm_scene(0.5);
  const Recording interrupted = simulate(scene, {}, [](double t) { return t < 0.2; });
  EXPECT_EQ(interrupted.outcome, Outcome::interrupted);
  EXPECT_NEAR(interrupted.frames.back().t, 0.2, 1.01 / 90);
  Options few;
  few.step_limit = 20;
  const Recording stalled = simulate(scene, few);
  EXPECT_EQ(stalled.outcome, Outcome::stalled);
  EXPECT_NE(stalled.note.find("step limit"), std::string::npos) << stalled.note;
}

TEST(Run, RejectsWrongInput) {
  const Scene scene = palm_scene(0.1);
  const auto with = [](double accuracy, double max_step, double rate, long limit) {
    return Options{accuracy, max_step, rate, limit};
  };
  EXPECT_THROW((void)simulate(scene, with(0, 1e-3, 90, 10)), InputError);
  EXPECT_THROW((void)simulate(scene, with(std::nan(""), 1e-3, 90, 10)), InputError);
  EXPECT_THROW((void)simulate(scene, with(1e-8, 0, 90, 10)), InputError);
  EXPECT_THROW((void)simulate(scene, with(1e-8, 1e-3, -1, 10)), InputError);
  EXPECT_THROW((void)simulate(scene, with(1e-8, 1e-3, 90, 0)), InputError);
}

// A hand that comes late: the palm is there from 0.05 s on and catches the deep block without a jump of its position.
TEST(Hand, ComesAndGoes) {
  Scene scene = palm_scene(0.1);
  scene.bodies[0].mobility = Mobility::fixed;
  Patch patch;
  patch.points = square(0.008);
  scene.hands[0] = hand_with({patch}, 0.08, 0.05, 1000);
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  ASSERT_EQ(r.events.size(), 8u);
  const double begin = scene.hands[0].motion->presence()[0].begin, end = scene.hands[0].motion->presence()[0].end;
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(r.events[i].kind, i < 4 ? EventKind::touch : EventKind::release);
    EXPECT_EQ(r.events[i].t, i < 4 ? begin : end);
  }
  EXPECT_LT(energy_residual(r), 1e-12);
}

// A seeded fingertip comes down on a fixed cube: patch at the contact offset, touch at the skin, dropped at twice the
// offset.
TEST(Hand, SeedsTouchesAndDropsAPatch) {
  Scene scene = cube_scene(0.5);
  scene.contact = {100, 0.5};
  scene.bodies[0].mobility = Mobility::fixed;
  const double radius = anatomical_hand().capsules[5].radius, w = 2 * pi / 0.4;
  Patch tip;
  tip.phalanx = 5;
  // Lies along x on the top face; its skin goes from 8 mm above to 2 mm below the face and back up.
  const Quaterniond along(Eigen::AngleAxisd(pi / 2, Vector3d::UnitY()));
  tip.pose = [=](double t) { return Pose{along, {0, 0, half_edge + radius + 0.003 + 0.005 * std::cos(w * t)}}; };
  scene.hands.push_back(hand_with({tip}, 0.6));
  scene.hands[0].given.clear();
  scene.patch.samples = 4;
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  const auto count = [&](EventKind kind) {
    return std::count_if(r.events.begin(), r.events.end(), [&](const Event& e) { return e.kind == kind; });
  };
  EXPECT_EQ(count(EventKind::touch), count(EventKind::release));
  EXPECT_GE(count(EventKind::touch), 2);  // the samples along the capsule at least
  const double t_touch = std::acos(-0.6) / w;
  EXPECT_NEAR(r.events.front().t, t_touch, 1e-6);  // skin points found to 1e-6 of the capsule's length
  for (const Frame& frame : r.frames) {
    const double gap = 0.003 + 0.005 * std::cos(w * frame.t);
    const std::size_t contacts = frame.contacts.size();
    EXPECT_TRUE(gap < 0.0041 || contacts == 0) << frame.t;
    EXPECT_TRUE(gap > 0.0019 || contacts == 4) << frame.t;
  }
  EXPECT_LT(energy_residual(r), 1e-9);
}

}  // namespace
}  // namespace handhold::reference
