// SPDX-License-Identifier: GPL-3.0-or-later
// The slider oscillator with the parameters of cases G01, G02, G04 and G05, against the catalogue's figures (computed
// by another program, copied with their id and set).
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cases/closed_form/ratchet.hpp"
#include "cases/closed_form/slider_oscillator.hpp"

namespace handhold::closed_form {
namespace {

TEST(SliderCases, HandStep) {  // G01, set 0: x and v at the catalogue's instant, found from x itself
  SliderOscillator o{.mass = 0.2, .stiffness = 1600, .friction = {0.5, 0.5}, .normal_force = {.constant = 8}};
  o.stretch = -0.001;
  const SliderMotion motion(o, 0.2);
  EXPECT_TRUE(motion.events().empty());
  const double w = std::sqrt(1600 / 0.2);
  const double phase = std::atan2(-0.08687372734049581 / (0.001 * w), 1 - 0.001237948391980591 / 0.001);
  const SliderState there = motion.at((phase + 2 * std::acos(-1.0)) / w);
  EXPECT_NEAR(there.x, 0.001237948391980591, 1e-15);
  EXPECT_NEAR(there.v, -0.08687372734049581, 1e-13);
  EXPECT_NEAR(-motion.at(0).friction, 1.6, 1e-15);
}

TEST(SliderCases, SuddenRelease) {  // G02, sets 0, 2 and 1
  struct Set {
    double N, mu_d, t_s, t_e, slip;
  };
  for (const Set& e : {Set{2.5, 0.5, 0.02066757868165247, 0.059877658811260275, 0.0020678438661710053},
                       Set{3, 0.4, 0.02379488639821559, 0.06629376874749934, 0.0019777397260273975}}) {
    SliderOscillator o{.mass = 0.2, .stiffness = 1600, .friction = {0.5, e.mu_d}};
    o.normal_force.constant = 2 * e.N;
    o.force.constant = 0.2 * 9.81;
    const SliderMotion motion(o, 0.1);
    EXPECT_NEAR(motion.breakaway().t, e.t_s, 1e-14);
    EXPECT_NEAR(motion.restick().t, e.t_e, 1e-14);
    EXPECT_NEAR(motion.restick().state.x - motion.breakaway().state.x, e.slip, 1e-15);
  }
  SliderOscillator holds{.mass = 0.2, .stiffness = 1600, .friction = {0.5, 0.5}};
  holds.normal_force.constant = 9;
  holds.force.constant = 0.2 * 9.81;
  EXPECT_TRUE(SliderMotion(holds, 1).events().empty());
}

TEST(SliderCases, MovingCatch) {  // G04, sets 0 and 1
  SliderOscillator o{.mass = 0.2, .stiffness = 800, .friction = {0.6, 0.4}};
  o.normal_force.constant = 1.5;
  o.base.rate = 0.2;
  const SliderMotion motion(o, 0.1);
  EXPECT_NEAR(motion.breakaway().t, 0.005750967431953856, 1e-15);
  EXPECT_NEAR(motion.restick().t, 0.06805621957368299, 1e-14);
  const auto lag = [](const SliderEvent& e) { return 0.2 * e.t - e.state.x; };
  EXPECT_NEAR(lag(motion.restick()) - lag(motion.breakaway()), 0.005822916666666667, 1e-15);
  o.mass = 0.05;
  o.base.rate = 0.1;
  const SliderMotion gentle(o, 0.1);
  EXPECT_TRUE(gentle.events().empty());
  EXPECT_NEAR(-gentle.at(std::acos(-1.0) / 2 / std::sqrt(800 / 0.05)).friction, 0.632455532033676, 1e-14);
}

TEST(SliderCases, Handover) {  // G05, set 0
  SliderOscillator o{.mass = 0.2, .stiffness = 1600, .friction = {0.5, 0.5}, .tether = 1200};
  o.normal_force = {.constant = 8, .rate = -8};
  o.force.constant = 0.2 * 9.81;
  o.stretch = 0.2 * 9.81 / 1600;
  const SliderMotion motion(o, 1);
  EXPECT_NEAR(motion.breakaway().t, 0.5095, 1e-9);  // unloads at 8 N/s: a rounding of the force, as a time
  EXPECT_NEAR(motion.at(1).x, 0.0016224945282334567, 1e-14);
  EXPECT_NEAR(motion.at(1).v, 0.00014385215820653848, 1e-12);
}

/// G06 by the smallest means: two sliders by return mapping, velocity Verlet in steps of `h`.
double stepped_creep(const Ratchet& r, double until, double h) {
  const ShakenPinch& p = r.pinch;
  double x = 0, v = 0, anchor[2] = {-p.mass * r.gravity / (2 * p.stiffness), -p.mass * r.gravity / (2 * p.stiffness)};
  const auto acceleration = [&](double t) {
    double force = p.mass * r.gravity;
    for (const int side : {0, 1}) {
      const double N = p.stiffness * (p.preload + (side == 0 ? -1 : 1) * relative_displacement(p, t));
      const double held = std::clamp(p.stiffness * (x - anchor[side]), -r.mu * N, r.mu * N);
      anchor[side] = x - held / p.stiffness;
      force -= held;
    }
    return force / p.mass;
  };
  const long steps = std::lround(until / h);
  double a = acceleration(0);
  for (long i = 1; i <= steps; ++i) {
    x += h * (v + 0.5 * h * a);
    const double next = acceleration(until * double(i) / double(steps));
    v += 0.5 * h * (a + next);
    a = next;
  }
  return x;
}

TEST(Ratchet, AgreesWithReturnMapping) {
  Ratchet r;
  r.pinch = {.stiffness = 800, .preload = 0.003, .amplitude = 1, .frequency = 6};
  r.pinch.amplitude = 0.001 / relative_amplitude(r.pinch);
  const double cycle = 2 * std::acos(-1.0) / 6;
  const RatchetMotion motion(r, 4);
  EXPECT_LT(motion.carrier_load(), 1);
  // Second order but for the changes of mode, in steps of 1 us.
  EXPECT_NEAR(motion.creep(cycle), stepped_creep(r, cycle, 1e-6), 1e-9);
  EXPECT_NEAR(motion.creep(2 * cycle - 1e-9), stepped_creep(r, 2 * cycle, 1e-6), 1e-9);
}

TEST(Ratchet, AgreesWithTheCatalogue) {  // G06, sets 0 and 1: infinitely slow
  Ratchet r;
  r.pinch = {.stiffness = 800, .preload = 0.003, .amplitude = 1, .frequency = 1};
  r.pinch.amplitude = 0.0015 / relative_amplitude(r.pinch);
  EXPECT_NEAR(slow_creep(r), 0.0019050000000000007, 1e-15);
  r.pinch.preload = 0.0035;
  r.pinch.amplitude *= 0.0008 / 0.0015;
  EXPECT_EQ(slow_creep(r), 0);
  EXPECT_LT(relative_amplitude(r.pinch), shakedown_amplitude(r));
}

}  // namespace
}  // namespace handhold::closed_form
