// SPDX-License-Identifier: GPL-3.0-or-later
// A cube on a palm that lies still: closed forms of one degree of freedom.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;
using namespace testing;

const Pose& last_pose(const Recording& r) { return r.frames.back().bodies[0].X_WO; }
const Twist& last_twist(const Recording& r) { return r.frames.back().bodies[0].V_WO; }

TEST(Free, FallsAndTurns) {
  Scene scene = cube_scene(0.5);
  scene.gravity = {0, 0, -gravity};
  scene.bodies[0].inertia.center = {0.01, 0, 0};
  scene.bodies[0].V_WO.w = {0, 0, 3};  // about a principal axis, through the centre of mass: steady
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete);
  ASSERT_EQ(r.frames.size(), 46u);
  EXPECT_EQ(r.frames.back().t, 0.5);
  // The centre starts with w × c = (0, 0.03, 0); O follows it on a circle of 10 mm.
  const double angle = 1.5;
  const Vector3d center(0.01, 0.03 * 0.5, -0.5 * gravity * 0.25);
  const Vector3d origin = center - 0.01 * Vector3d(std::cos(angle), std::sin(angle), 0);
  EXPECT_LT((last_pose(r).p - origin).norm(), 1e-9);  // 500 steps of accuracy 1e-10, most of them far better
  EXPECT_LT((last_twist(r).w - Vector3d(0, 0, 3)).norm(), 1e-9);
  EXPECT_LT((last_twist(r).v - Vector3d(0.03 * std::sin(angle), 0.03 - 0.03 * std::cos(angle), -gravity * 0.5)).norm(),
            1e-9);
  EXPECT_LT(energy_residual(r), 1e-9);
  EXPECT_TRUE(r.events.empty());
}

// A load F sin(w t) at the centre of mass, and a torque T cos(w t): m x'' = F sin(w t), I phi'' = T cos(w t), from
// rest.
TEST(Free, FollowsItsLoad) {
  const double F = 0.3, T = 1e-4, w = 20, duration = 0.3;
  Scene scene = cube_scene(duration);
  scene.bodies[0].inertia.center = {0.01, 0, 0};  // the force must not turn it
  scene.bodies[0].load = [=](double t) { return Load{{F * std::sin(w * t), 0, 0}, {0, 0, T * std::cos(w * t)}}; };
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  const double m = 0.2, I = scene.bodies[0].inertia.about_center(2, 2);
  const double angle = T / I * (1 - std::cos(w * duration)) / (w * w);
  const double x = 0.01 + F / m * (duration / w - std::sin(w * duration) / (w * w));
  const Vector3d origin = Vector3d(x, 0, 0) - 0.01 * Vector3d(std::cos(angle), std::sin(angle), 0);
  EXPECT_LT((last_pose(r).p - origin).norm(), 1e-9);  // as FallsAndTurns
  EXPECT_NEAR(2 * std::atan2(last_pose(r).R.z(), last_pose(r).R.w()), angle, 1e-9);
  const double speed = F / m * (1 - std::cos(w * duration)) / w, spin = T / I * std::sin(w * duration) / w;
  EXPECT_NEAR(r.frames.back().energy.hand_work, 0.5 * m * speed * speed + 0.5 * I * spin * spin, 1e-9);
  EXPECT_LT(energy_residual(r), 1e-9);
}

// Carried through oil, v = F τ / m after the start has died away, e^(−t / τ).
TEST(Free, FollowsItsLoadThroughOil) {
  Scene scene = cube_scene(0.3);
  scene.bodies[0].held_until = 1;
  scene.bodies[0].load = [](double) { return Load{{0.04, 0, 0}, {0, 0, 0}}; };
  const Recording r = simulate(scene, {});
  EXPECT_NEAR(last_twist(r).v.x(), 0.04 * support_time / 0.2, 1e-11);
  EXPECT_LT(energy_residual(r), 1e-9);
}

TEST(Palm, HoldsABlockStill) {
  const Recording r = simulate(palm_scene(1), {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  EXPECT_TRUE(r.events.empty());
  const Vector3d start = r.frames.front().bodies[0].X_WO.p;
  for (const Frame& frame : r.frames) {
    // The spline's zero is known to round-off, 1e-16 m: the block swings about it (no damping) and nothing more in any
    // time, for stick has no creep.
    const Vector3d moved = frame.bodies[0].X_WO.p - start;
    EXPECT_LT(std::abs(moved.z()), 1e-15);
    EXPECT_LT(moved.head<2>().norm(), 1e-17);
    EXPECT_LT(frame.bodies[0].V_WO.v.norm(), 1e-13);
    ASSERT_EQ(frame.contacts.size(), 4u);
    for (const ContactState& c : frame.contacts) {
      EXPECT_EQ(c.mode, Mode::stick);
      EXPECT_NEAR(c.f_W.z(), 0.2 * gravity / 4, 1e-12);  // the palm pushes up
      EXPECT_NEAR(c.depth, palm_depth(), 1e-15);
      EXPECT_LT((c.n_W - Vector3d(0, 0, -1)).norm(), 1e-12);
    }
  }
}

Scene sliding_scene(double duration, double speed, double damping = 0) {
  Scene scene = palm_scene(duration, {Vector3d(-1e-3, 0, 0), true});
  scene.bodies[0].mobility = Mobility::translation;
  scene.bodies[0].V_WO.v = {speed, 0, 0};
  scene.contact.damping = damping;
  return scene;
}

// Coulomb: deceleration mu_d g exactly (the block starts in vertical equilibrium), stop at v0 / (mu_d g); then it hangs
// on the loaded springs and swings about the middle with w = sqrt(4 k / m), from −mu_d m g / (4 k).
TEST(Palm, LetsABlockSlideAndStop) {
  const double mu = 0.4, v0 = 0.2, t_stop = v0 / (mu * gravity), distance = v0 * v0 / (2 * mu * gravity);
  const Recording r = simulate(sliding_scene(0.1, v0), {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  ASSERT_EQ(r.events.size(), 4u);
  for (const Event& event : r.events) {
    EXPECT_EQ(event.kind, EventKind::restick);
    EXPECT_NEAR(event.t, t_stop, 1e-9);
    EXPECT_LE(event.window, 1e-9);
  }
  const double lag = mu * gravity * 0.2 / 1600, w = std::sqrt(1600 / 0.2);
  for (const Frame& frame : r.frames) {
    const double t = frame.t, after = t - t_stop;
    const double x = after < 0 ? v0 * t - 0.5 * mu * gravity * t * t : distance - lag * (1 - std::cos(w * after));
    EXPECT_NEAR(frame.bodies[0].X_WO.p.x(), x, 1e-8) << "t = " << t;
  }
  EXPECT_LT(energy_residual(r), 1e-8);
}

// With damping the sliding force is the same; the lag relaxes to mu_d N / k with the time constant c / k from whatever
// it was: c e' = ... the slider passes on mu_d N, so that k e + c e' = mu_d N.
TEST(Palm, RelaxesTheLagOfADampedSlide) {
  const double mu = 0.4, v0 = 0.3, c = 4;
  const Recording r = simulate(sliding_scene(0.03, v0, c), {});  // 7 mm: far from the edges
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  EXPECT_TRUE(r.events.empty());
  const double steady = mu * palm_depth(), tau = c / 400;
  for (const Frame& frame : r.frames) {
    const double t = frame.t;
    EXPECT_NEAR(frame.bodies[0].X_WO.p.x(), v0 * t - 0.5 * mu * gravity * t * t, 1e-8);
    const double lag = steady + (1e-3 - steady) * std::exp(-t / tau);
    for (const ContactState& s : frame.contacts) {
      EXPECT_NEAR(s.C_W.x() - s.p_W.x(), lag, 1e-8);
      EXPECT_NEAR(s.f_W.x(), -mu * 0.2 * gravity / 4, 1e-9);
    }
  }
  EXPECT_LT(energy_residual(r), 1e-8);
}

// Dropped from h on damped springs: m z'' = −m g + 4 (k d + c d'), d = −z from the touch, closed form of the linear
// oscillator.
TEST(Palm, CatchesABlockOnDampedSprings) {
  const double h = 0.01, m = 0.2, k = 1600, c = 8, duration = 0.065;
  Scene scene = palm_scene(duration);
  scene.bodies[0].X_WO.p.z() = half_edge + h;
  scene.contact.damping = c / 4;
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  const double t_touch = std::sqrt(2 * h / gravity), v = gravity * t_touch;
  ASSERT_EQ(r.events.size(), 4u);
  for (const Event& event : r.events) {
    EXPECT_EQ(event.kind, EventKind::touch);
    EXPECT_NEAR(event.t, t_touch, 1e-9);
  }
  const double tau = duration - t_touch, a = c / (2 * m), w = std::sqrt(k / m - a * a), rest = m * gravity / k;
  const double d = rest + std::exp(-a * tau) * (-rest * std::cos(w * tau) + (v - a * rest) / w * std::sin(w * tau));
  // The contact starts at depth 1e-10 m, not 0: the damper's first 1e-10 m / v seconds are missing.
  EXPECT_NEAR(last_pose(r).p.z(), half_edge - d, 2e-9);
  EXPECT_LT(energy_residual(r), 1e-8);
}

// Undamped: leaves the palm again with the energy it had, B04 of the case list: contact time (2/w)(pi − atan(w v0 /
// g)).
TEST(Palm, BouncesABlockBack) {
  const double h = 0.01, m = 0.2, k = 1600;
  Scene scene = palm_scene(0.12);
  scene.bodies[0].X_WO.p.z() = half_edge + h;
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  ASSERT_EQ(r.events.size(), 8u);
  const double w = std::sqrt(k / m), v = std::sqrt(2 * gravity * h), t_touch = v / gravity;
  const double t_release = t_touch + 2 / w * (std::acos(-1.0) - std::atan(w * v / gravity));
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(r.events[i].kind, i < 4 ? EventKind::touch : EventKind::release);
    EXPECT_NEAR(r.events[i].t, i < 4 ? t_touch : t_release, 2e-9);  // touch depth 1e-10 m / 0.44 m/s, and integration
  }
  EXPECT_LT(energy_residual(r), 1e-8);
}

// Frictionless, the block keeps its speed.
TEST(Palm, IsSlipperyWithoutFriction) {
  for (const double damping : {0.0, 0.5}) {
    Scene scene = sliding_scene(0.1, 0.1, damping);
    scene.bodies[0].friction = {0, 0};
    scene.hands[0].given[0].start.clear();
    const Recording r = simulate(scene, {});
    ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
    EXPECT_NEAR(last_pose(r).p.x(), 0.01, 1e-11);
    EXPECT_TRUE(r.events.empty());
    EXPECT_LT(energy_residual(r), 1e-9);
  }
}

// A lag of more than mu_s d at the start: breaks away at t = 0, as if it had been slipping.
TEST(Palm, SlipsFromAStartOutsideTheCone) {
  Scene outside = palm_scene(0.05, {Vector3d(-2 * 0.5 * palm_depth(), 0, 0), false});
  outside.bodies[0].mobility = Mobility::translation;
  outside.bodies[0].V_WO.v = {0.3, 0, 0};
  const Recording r = simulate(outside, {});
  for (const ContactState& c : r.frames.front().contacts) EXPECT_EQ(c.mode, Mode::slip);
  EXPECT_NEAR(last_pose(r).p.x(), 0.3 * 0.05 - 0.5 * 0.4 * gravity * 0.0025, 1e-8);
  EXPECT_TRUE(r.events.empty());
}

// A damped element touched while sliding slips at once: t* = c v_t > mu_s c v_n.
TEST(Palm, SlipsAtTouchWhenSliding) {
  for (const double damping : {0.0, 1.0}) {
    const double t_touch = std::sqrt(2 * 0.01 / gravity), t = 0.008;  // slides 8 mm: far from the edges
    Scene scene = palm_scene(t_touch + t);
    scene.bodies[0].mobility = Mobility::translation;
    scene.bodies[0].X_WO.p = {-t_touch, 0, half_edge + 0.01};
    scene.bodies[0].V_WO.v = {1, 0, 0};  // against 0.44 m/s down
    scene.contact.damping = damping;
    const Recording r = simulate(scene, {});
    ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
    ASSERT_EQ(r.events.size(), 4u);
    for (const ContactState& c : r.frames.back().contacts) EXPECT_EQ(c.mode, Mode::slip);
    // Momentum: m dv_x = −mu_d N dt and m dv_z = (N − m g) dt, so dv_x = −mu_d (dv_z + g dt) since the touch.
    const double dv_z = last_twist(r).v.z() + gravity * t_touch;
    EXPECT_NEAR(last_twist(r).v.x(), 1 - 0.4 * (dv_z + gravity * t), 1e-8);
    EXPECT_LT(energy_residual(r), 1e-8);
  }
}

TEST(Palm, LetsAHeldBodyGo) {
  Scene scene = palm_scene(0.2);
  scene.bodies[0].X_WO.p.z() = half_edge;  // no contact force yet
  scene.bodies[0].held_until = 0.1;
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  for (const Frame& frame : r.frames) EXPECT_TRUE(frame.t >= 0.1 || frame.bodies[0].X_WO.p.z() == half_edge);
  const double w = std::sqrt(1600 / 0.2), rest = 0.2 * gravity / 1600;
  EXPECT_NEAR(last_pose(r).p.z(), half_edge - rest * (1 - std::cos(w * 0.1)), 1e-8);  // from rest, undamped
}

// Thick oil: a palm that rises with speed v pushes with K d = m v / τ.
TEST(Palm, PushesAHeldBodyThroughOil) {
  Scene scene = palm_scene(0.2);
  scene.bodies[0].X_WO.p.z() = half_edge;
  scene.bodies[0].held_until = 1;
  const double speed = 0.02;
  Patch patch;
  patch.points = square(0.008);
  patch.pose = [=](double t) { return Pose{Eigen::Quaterniond::Identity(), {0, 0, speed * t}}; };
  scene.hands[0] = hand_with({patch}, 0.5);
  scene.duration = 0.5;
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  const double stiffness = 1600, mass = 0.2;
  const double depth = mass * speed / (support_time * stiffness);
  EXPECT_NEAR(r.frames.back().contacts[0].depth, depth, 1e-6 * depth);  // e^(-t / (2 τ)) = e^(-25) after the ring
  EXPECT_LT(energy_residual(r), 1e-9);
}

// The support hides the weight: the palm comes and goes without the body moving, and the hand's work is what the
// springs hold.
TEST(Palm, KeepsAFixedBody) {
  Scene scene = palm_scene(0.2);
  scene.bodies[0].mobility = Mobility::fixed;
  Patch patch;
  patch.points = square(0.008);
  patch.pose = [](double t) { return Pose{Eigen::Quaterniond::Identity(), {0.02 * t, 0, 0.002 * std::sin(20 * t)}}; };
  scene.hands[0] = hand_with({patch}, 0.3);
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  EXPECT_EQ(last_pose(r).p, scene.bodies[0].X_WO.p);
  EXPECT_LT(energy_residual(r), 1e-9);
}

}  // namespace
}  // namespace handhold::reference
