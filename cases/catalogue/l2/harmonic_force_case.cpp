// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 8;
const Eigen::Vector3d along = Eigen::Vector3d::UnitX();

closed_form::SliderOscillator pushed() {
  closed_form::SliderOscillator o{.mass = 0.2, .stiffness = 4000, .damping = 40, .friction = {0.5, 0.4}};
  o.normal_force.constant = o.mass * 9.81;
  o.force = {.amplitude = 1.4, .frequency = 10};
  start_in_forced_stick(o);
  return o;
}

}  // namespace

Case harmonic_force_case() {
  const auto o = pushed();
  const double end = 65.0 / 90;
  const SliderClaims expect(o, end, along, samples);
  Run run{.name = "stick-slip",
          .problem = [=] { return palm_scene("C05 harmonic force", o, {.samples = samples}, end); }};
  run.claims = {expect.breakaway(1, "first onset"),
                expect.restick(1, "first stop"),
                expect.slip_at_restick(1, "slip of the first half cycle"),
                expect.breakaway(2, "second onset"),
                expect.restick(2, "second stop"),
                expect.slip(45.0 / 90, "place at t = 0.5 s")};
  run.curve = expect.curve("slip [m]");
  return {.id = "C05",
          .title = "Block under a harmonic force: stick-slip",
          .truth_level = "L2",
          .statement = "A 0.2 kg block on a palm is pushed to and fro with 1.4 N sin(10 t); mu_s = 0.5, mu_d = 0.4.",
          .formula =
              "L1: sin(w t1) = mu_s m g / F0; slides until v(t) = F0/(m w) (cos w t1 - cos w t) - mu_d g (t - t1) "
              "is 0 again; then the mirror image. L2: slider oscillator",
          .note =
              "K = 4000 N/m, C = 40 N s/m, 8 samples, started in the forced motion of the springs. L1: 0.077640 s, "
              "0.362696 s, 64.641 mm, 0.391799 s.",
          .runs = {run}};
}

}  // namespace handhold::catalogue
