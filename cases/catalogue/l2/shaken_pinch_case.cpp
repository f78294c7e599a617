// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <complex>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 16;  // of both fingers
constexpr double gravity = 9.81;
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

closed_form::SliderOscillator shaken(double amplitude) {
  closed_form::SliderOscillator o{.mass = 0.2, .stiffness = 6400, .damping = 32, .friction = {0.5, 0.5}};
  o.normal_force.constant = 2 * 2.6;
  o.force.constant = -o.mass * gravity;
  o.base = {.amplitude = amplitude, .frequency = 25};
  start_in_forced_stick(o);
  return o;
}

/// The largest amplitude without slip: m (g + A ω² |H|) = 2 μ_s N, H the stuck object's motion over the hand's.
double critical_amplitude() {
  const auto o = shaken(1);
  const double w = o.base.frequency;
  const std::complex<double> spring{o.stiffness, o.damping * w};
  const double gain = std::abs(spring / (spring - o.mass * w * w));
  return (o.friction.mu_static * o.normal_force.constant / o.mass - gravity) / (w * w * gain);
}

Run slipping_run() {
  const auto o = shaken(0.01);
  const double end = 0.55;
  const SliderClaims expect(o, end, up, samples);
  Run run{.name = "slips down", .problem = [=] { return pinch_scene("D04 pinch shaken vertically", o, end); }};
  run.claims = {expect.breakaway(1, "first onset"),
                expect.restick(1, "first stop"),
                expect.slip_at_restick(1, "slip at the first stop"),
                expect.breakaway(2, "second onset"),
                expect.restick(2, "second stop"),
                expect.slip(49.0 / 90, "slip at t = 49/90 s")};
  run.curve = expect.curve("slip [m]");
  return run;
}

Run threshold_run(double share) {
  const auto o = shaken(share * critical_amplitude());
  const double end = 0.55;  // two periods
  return near_threshold(
      share, [=] { return pinch_scene("D04 near the threshold", o, end); },
      yes_or_no("holds", share < 1, "L2: m (g + A w^2 |H|) <= 2 mu_s N", none_of(EventKind::breakaway)));
}

}  // namespace

Case shaken_pinch_case() {
  return {.id = "D04",
          .title = "Pinch shaken vertically: one-sided drift",
          .truth_level = "L2",
          .statement =
              "A 0.2 kg block between two fingers that press with 2.6 N each and move as 10 mm sin(25 t) up and down; "
              "mu = 0.5.",
          .formula =
              "L1: holds iff A w^2 <= 2 mu_s N/m - g; else slips down while the hand accelerates up. "
              "L2: A w^2 times |H|, H = (K + i C w)/(K + i C w - m w^2); slider oscillator",
          .note =
              "K = 6400 N/m, C = 32 N s/m of 2 x 8 samples, started in the forced motion without slip. L1: onset "
              "0.147090 s, stop 0.277119 s, 12.101 mm.",
          .runs = {slipping_run(), threshold_run(0.98), threshold_run(1.02)}};
}

}  // namespace handhold::catalogue
