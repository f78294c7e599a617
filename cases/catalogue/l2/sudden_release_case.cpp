// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 16;
constexpr double gravity = 9.81;
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

closed_form::SliderOscillator released(double normal_force, const Friction& friction) {
  closed_form::SliderOscillator o{.mass = 0.2, .stiffness = 1600, .friction = friction};
  o.normal_force.constant = 2 * normal_force;
  o.force.constant = -o.mass * gravity;
  return o;
}

Run slipping_run(double normal_force, const Friction& friction) {
  const auto o = released(normal_force, friction);
  const double end = 0.1;
  const SliderClaims expect(o, end, up, samples);
  Run run{.name = fmt::format("N = {} N, mu_d = {}", normal_force, friction.mu_dynamic),
          .problem = [=] { return pinch_scene("G02 sudden release", o, end); }};
  run.claims = {expect.breakaway(1, "slip onset"), expect.restick(1, "stop"),
                expect.slip_at_restick(1, "place at the stop"), expect.slip(end, "place at t = 0.1 s")};
  const double frequency = std::sqrt(o.stiffness / o.mass),
               braking = 2 * friction.mu_dynamic * normal_force / o.mass - gravity;
  run.claims[1].controlled = absolute_controlled_limit(
      1 + frequency / braking, "the oscillation's speed is known to w times its place; over the braking");
  run.curve = expect.curve("place [m]");
  return run;
}

/// 2 m g = share · 2 μ_s N.
Run threshold_run(double share) {
  const auto o = released(0.2 * gravity / (share * 0.5), {0.5, 0.5});
  const double end = 0.25;  // three and a half periods
  Run run = near_threshold(
      share, [=] { return pinch_scene("G02 near the threshold", o, end); },
      yes_or_no("holds", share < 1, "L2: no slip iff 2 m g <= 2 mu_s N, dynamic load factor 2",
                none_of(EventKind::breakaway)));
  run.not_stepped =
      "the implicit step damps the first swing by exp(-pi w h/2), a third at w h = 0.25, and so holds 16 % more than "
      "the "
      "law; a pinch soft enough for 1 % would sag by 0.9 m";
  return run;
}

}  // namespace

Case sudden_release_case() {
  Run holds = threshold_run(0.98), slips = threshold_run(1.02);
  return {.id = "G02",
          .title = "Sudden release in a compliant pinch: dynamic load factor 2",
          .truth_level = "L2",
          .statement = "A 0.2 kg cube between two fingers with slack springs is let go under gravity; mu_s = 0.5.",
          .formula =
              "no slip iff 2 m g <= 2 mu_s N; else v_c^2 = 2 g x_s - K x_s^2/m at x_s = 2 mu_s N/K, slip "
              "m v_c^2/(2 (2 mu_d N - m g)), then stick oscillation of amplitude (2 mu_d N - m g)/K",
          .note =
              "K = 1600 N/m, undamped; slider oscillator. L1 holds both runs that slip: 2 mu_s N > m g, which is why a "
              "compliant hand drops what a rigid one holds. The slip of the catalogue leaves out the stretch x_s.",
          .runs = {slipping_run(2.5, {0.5, 0.5}), slipping_run(3, {0.5, 0.4}), holds, slips}};
}

}  // namespace handhold::catalogue
