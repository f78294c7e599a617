// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 16;
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

closed_form::SliderOscillator caught(double mass, double speed) {
  closed_form::SliderOscillator o{.mass = mass, .stiffness = 800, .friction = {.mu_static = 0.6, .mu_dynamic = 0.4}};
  o.normal_force.constant = 1.5;
  o.base.rate = speed;
  return o;
}

Run slipping_run() {
  const auto o = caught(0.2, 0.2);
  const double end = 9.0 / 90;
  const SliderClaims expect(o, end, up, samples);
  Run run{.name = "V = 0.2 m/s slips", .problem = [=] { return pinch_scene("G04 catch", o, end); }};
  run.claims = {expect.breakaway(1, "slip onset"), expect.restick(1, "end of slip"),
                expect.slip_at_restick(1, "lag behind the hand then"), expect.slip(end, "lag at t = 0.1 s")};
  const double frequency = std::sqrt(o.stiffness / o.mass);
  const double pull = o.friction.mu_dynamic * o.normal_force.constant / o.mass;
  run.claims[1].controlled = absolute_controlled_limit(
      1 + frequency / pull, "the oscillation's speed is known to w times its place; over the acceleration");
  run.curve = expect.curve("object - hand [m]");
  return run;
}

Run sticking_run() {
  const auto o = caught(0.05, 0.1);
  const double end = 6.0 / 90;
  const SliderClaims expect(o, end, up, samples);
  Run run{.name = "V = 0.1 m/s, m = 50 g sticks", .problem = [=] { return pinch_scene("G04 gentle catch", o, end); }};
  run.claims = {expect.slip(1.0 / 90, "lag at t = 1/90 s"), expect.slip(end, "lag at t = 1/15 s")};
  run.claims.push_back(
      yes_or_no("sticks", true, "L2: V sqrt(K m) = 0.632 N <= mu_s N = 0.9 N", none_of(EventKind::breakaway)));
  run.curve = expect.curve("object - hand [m]");
  return run;
}

}  // namespace

Case moving_catch_case() {
  return {.id = "G04",
          .title = "Fingertips at speed V catch a free block: compliant start",
          .truth_level = "L2",
          .statement = "Two fingers that move at V grip a free 0.2 kg block; N = 1.5 N in all, mu_s = 0.6, mu_d = 0.4.",
          .formula =
              "no slip iff V sqrt(K m) <= mu_s N: e = V/w sin w t; else slips at sin(w t1) = mu_s N/(V sqrt(K m)), "
              "a = mu_d N/m until v = V: t2 = t1 + V cos(w t1) m/(mu_d N), slip (V cos w t1)^2 m/(2 mu_d N)",
          .note =
              "K = 800 N/m of 2 x 8 samples, undamped, no gravity. The catalogue's finger on ice is a pinch here, of "
              "the same K and N in all. Lags count from the slack springs; the slip is the lag less mu_s N/K.",
          .runs = {slipping_run(), sticking_run()}};
}

}  // namespace handhold::catalogue
