// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr double step = 0.001;  // s of the hand [m]
constexpr int samples = 16;
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

/// The mass for which half a period is three frames, so that the overshoot falls on a frame (0.18 kg).
closed_form::SliderOscillator dragged() {
  const double frequency = 30 * std::numbers::pi;
  closed_form::SliderOscillator o{
      .mass = 1600 / (frequency * frequency), .stiffness = 1600, .friction = {.mu_static = 0.5, .mu_dynamic = 0.5}};
  o.normal_force.constant = 2 * 4.0;
  o.stretch = -step;  // the hand is ahead: how a jump looks just after it
  return o;
}

}  // namespace

Case drag_step_case() {
  const auto o = dragged();
  const double end = 9.0 / 90;
  const SliderClaims expect(o, end, up, samples);
  Run run{.name = "rings", .problem = [=] { return pinch_scene("G01 hand step", o, end); }};
  run.claims = {expect.slip(1.0 / 90, "x at t = 1/90 s"), expect.speed(2.0 / 90, "speed at t = 2/90 s"),
                expect.slip(3.0 / 90, "overshoot 2 s, t = 3/90 s"), expect.slip(end, "overshoot 2 s, t = 0.1 s")};
  run.claims[1].converges = true;
  run.claims[1].controlled =
      absolute_controlled_limit(std::sqrt(o.stiffness / o.mass), "a speed of the oscillation is w times its place");
  run.claims.push_back(yes_or_no("sticks", true, "L2: K s = 1.6 N <= 2 mu N = 4 N", none_of(EventKind::breakaway)));
  run.curve = expect.curve("x [m]");
  return {.id = "G01",
          .title = "Sticking object dragged by a hand step: tangential oscillation",
          .truth_level = "L2",
          .statement =
              "A 0.18 kg cube between two fingers, 4 N each, mu = 0.5, no gravity; the hand has jumped by s = 1 mm.",
          .formula = "sticks iff K s <= 2 mu N; x = s (1 - cos w t), w = sqrt(K/m), overshoot 2 s, v_max = s w",
          .note =
              "K = 1600 N/m, undamped; the jump is a start with the springs stretched by s. L1 has no such motion: the "
              "object would jump too.",
          .runs = {run}};
}

}  // namespace handhold::catalogue
