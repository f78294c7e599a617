// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 8;
constexpr double amplitude = 0.05, frequency = 20, mu = 0.4, gravity = 9.81;
const Eigen::Vector3d along = Eigen::Vector3d::UnitX();

/// Starts on the periodic orbit of L1: the object's speed is a triangle wave of height π μ g / (2 ω), which is reached
/// when the palm has that speed.
closed_form::SliderOscillator carried() {
  closed_form::SliderOscillator o{.mass = 0.2, .stiffness = 1600, .damping = 0.8, .friction = {mu, mu}};
  o.normal_force.constant = o.mass * gravity;
  o.base = {.amplitude = amplitude, .frequency = frequency};
  const double peak = std::numbers::pi * mu * gravity / (2 * frequency);
  const double turn = std::acos(peak / (amplitude * frequency)) / frequency;
  o.v = peak - mu * gravity * turn;
  o.direction = -1;
  o.stretch = -mu * o.normal_force.constant / o.stiffness;
  return o;
}

}  // namespace

Case oscillating_palm_case() {
  const auto o = carried();
  const double end = 0.7;
  const SliderClaims expect(o, end, along, samples);
  Run run{.name = "slides to and fro",
          .problem = [=] { return palm_scene("C09 oscillating palm", o, {.samples = samples}, end); }};
  run.claims = {expect.restick(1, "first reversal"),
                expect.breakaway(1, "slides the other way"),
                expect.restick(2, "second reversal"),
                expect.slip_at_restick(2, "place at the second reversal"),
                expect.slip(42.0 / 90, "place at t = 42/90 s"),
                expect.slip(60.0 / 90, "place at t = 2/3 s")};
  run.curve = expect.curve("slip [m]");
  return {.id = "C09",
          .title = "Object on a horizontally oscillating palm",
          .truth_level = "L2",
          .statement = "A 0.2 kg block lies on a palm that moves as 50 mm sin(20 t); mu = 0.4.",
          .formula =
              "L1: slides all the time if (A w^2)^2 >= (mu g)^2 (1 + pi^2/4); its speed is a triangle wave of height "
              "pi mu g/(2 w), with reversals at cos(w t) = pi mu g/(2 A w^2). L2: slider oscillator",
          .note = "K = 1600 N/m, C = 0.8 N s/m, 8 samples; started on the orbit of L1 (first reversal 0.062875 s).",
          .runs = {run}};
}

}  // namespace handhold::catalogue
