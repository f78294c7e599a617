// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 16;  // of both fingers
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

closed_form::SliderOscillator falling() {
  closed_form::SliderOscillator o{.mass = 0.2, .stiffness = 6400, .damping = 32, .friction = {0.5, 0.4}};
  o.normal_force = {.constant = 2 * 2, .rate = 2 * 8};
  o.force.constant = -o.mass * 9.81;
  o.v = -0.15;
  o.direction = -1;
  o.stretch = -o.friction.mu_dynamic * o.normal_force.constant / o.stiffness;
  return o;
}

}  // namespace

Case catch_case() {
  const auto o = falling();
  const double end = 36.0 / 90;
  const SliderClaims expect(o, end, up, samples);
  Run run{.name = "catches", .problem = [=] { return pinch_scene("D03 catch", o, end); }};
  Claim mid = expect.slip(12.0 / 90, "fall at t = 2/15 s");
  mid.converges = true;
  run.claims = {expect.restick(1, "stop"), expect.slip_at_restick(1, "fall to the stop"), mid,
                expect.slip(end, "place at t = 0.4 s"),
                yes_or_no("holds from then on", expect.truth().events().size() == 1,
                          "L2: the springs swing within the growing cone", none_of(EventKind::breakaway))};
  run.curve = expect.curve("rise [m]");
  return {
      .id = "D03",
      .title = "Catch: closing fingers stop a falling object",
      .truth_level = "L2",
      .statement =
          "A 0.2 kg block slides down between two fingers with 0.15 m/s; each presses with 2 N + 8 N/s t; mu_s = 0.5, "
          "mu_d = 0.4.",
      .formula =
          "L1: t = (b + sqrt(b^2 + 2 c v0))/c, b = g - 2 mu_d N0/m, c = 2 mu_d r/m; fall v0 t + b t^2/2 - c t^3/6. "
          "L2: re-stick as soon as the springs' kinetic lag grows faster than the object falls, "
          "v = mu_d N'/K; then they swing",
      .note = "K = 6400 N/m, C = 32 N s/m of 2 x 8 samples.",
      .runs = {run}};
}

}  // namespace handhold::catalogue
