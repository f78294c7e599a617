// SPDX-License-Identifier: GPL-3.0-or-later
// C06, C07 and C08: a block on a palm, tied by the spring that two opposite fingers make.
#include <numbers>

#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 32;  // of the palm; with one sample a finger the tether has 1/16 of its stiffness
const Eigen::Vector3d along = Eigen::Vector3d::UnitX();

/// 25 N/m and 0.1 N s/m a sample.
closed_form::SliderOscillator tied(const Friction& friction) {
  closed_form::SliderOscillator o{.mass = 0.2, .stiffness = 800, .damping = 3.2, .friction = friction};
  o.normal_force.constant = o.mass * 9.81;
  o.tether = 50;
  o.tether_damping = 0.2;
  return o;
}

Run run_of(const std::string& name, const closed_form::SliderOscillator& o, double finger_depth, double end) {
  return {.name = name, .problem = [=] { return palm_scene(name, o, {samples, finger_depth}, end); }};
}

}  // namespace

Case friction_oscillator_case() {
  auto o = tied({0.12, 0.075});
  o.x = 0.02;
  o.direction = -1;
  o.stretch = -o.friction.mu_static * o.normal_force.constant / o.stiffness;  // just broken away
  const double end = 0.8;
  const SliderClaims expect(o, end, along, samples);
  Run run = run_of("let go", o, 0.024, end);
  run.claims = {expect.restick(1, "first turn"),
                expect.slip_at_restick(1, "way to the first turn"),
                expect.breakaway(1, "way back begins"),
                expect.restick(2, "second turn"),
                expect.slip_at_restick(2, "way to the second turn"),
                expect.restick(3, "stops for good"),
                expect.slip_at_restick(3, "way to the stop"),
                expect.slip(end, "rest, t = 0.8 s")};
  run.curve = expect.curve("way [m]");
  return {.id = "C06",
          .title = "Free oscillator with Coulomb friction",
          .truth_level = "L2",
          .statement =
              "A 0.2 kg block on a palm, tied by a spring of 50 N/m, is let go 20 mm off; mu_s = 0.12, mu_d = 0.075.",
          .formula =
              "L1: turns after pi sqrt(m/k) each, at (-1)^j (x0 - 2 j mu_d m g / k), until k |x| <= mu_s m g. "
              "L2: slider oscillator",
          .note =
              "Tether: two fingers of one sample each (k = 25 N/m, c = 0.1 N s/m) deep in the block's ends; palm: 32 "
              "such samples. L1, undamped: turns at -14.1, 8.2 mm, stops at -2.3 mm after 0.596 s.",
          .runs = {run}};
}

Case forced_oscillator_case() {
  auto o = tied({0.1, 0.1});
  o.force = {.amplitude = 0.5, .frequency = 10, .phase = std::numbers::pi / 2};
  const double end = 1.5;
  const SliderClaims expect(o, end, along, samples);
  Run run = run_of("shaken", o, 0.026, end);
  run.claims = {expect.breakaway(1, "first onset"),
                expect.restick(1, "first turn"),
                expect.slip_at_restick(1, "way to the first turn"),
                expect.restick(4, "fourth turn"),
                expect.slip_at_restick(4, "way to the fourth turn"),
                expect.slip(end, "place at t = 1.5 s")};
  run.curve = expect.curve("way [m]");
  return {.id = "C07",
          .title = "Den Hartog: forced oscillator with dry friction",
          .truth_level = "L2",
          .statement =
              "A 0.2 kg block on a palm, tied by a spring of 50 N/m, at rest; from t = 0 a force 0.5 N cos(10 t) acts; "
              "mu = 0.1.",
          .formula =
              "L1: steady amplitude (F0/k) sqrt(V^2 - (mu m g/F0)^2 U^2), V = 1/(1 - w^2/wn^2), "
              "U = b sin(pi b)/(1 + cos(pi b)), b = wn/w. L2: slider oscillator, from rest",
          .note = "Palm and fingers as in C06. L1: steady amplitude 15.96 mm.",
          .runs = {run}};
}

Case belt_case() {
  auto o = tied({0.6, 0.4});
  o.base.rate = 0.05;
  start_in_forced_stick(o);
  const double end = 1.35;
  const SliderClaims expect(o, end, along, samples);
  Run run = run_of("stick-slip", o, 0.03, end);
  run.claims = {expect.breakaway(1, "first breakaway"),
                expect.restick(1, "first re-stick"),
                expect.slip_at_restick(1, "slip against the belt at the first re-stick"),
                expect.breakaway(2, "second breakaway"),
                expect.restick(2, "second re-stick"),
                expect.slip(120.0 / 90, "slip against the belt at t = 4/3 s")};
  run.curve = expect.curve("slip against the belt [m]");
  return {
      .id = "C08",
      .title = "Stick-slip oscillator on a belt",
      .truth_level = "L2",
      .statement =
          "A 0.2 kg block, tied by a spring of 50 N/m, on a palm that moves with 50 mm/s; mu_s = 0.6, mu_d = 0.4.",
      .formula =
          "L1: sticks for 2 D/V, slips for (2/w) (pi - atan(w D/V)), D = (mu_s - mu_d) m g/k. L2: slider oscillator",
      .note = "Palm and fingers as in C06. L1: sticks 0.313920 s, slips 0.247143 s.",
      .runs = {run}};
}

}  // namespace handhold::catalogue
