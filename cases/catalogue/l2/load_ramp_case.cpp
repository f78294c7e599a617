// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 8;
const Eigen::Vector3d along = Eigen::Vector3d::UnitX();

/// The ramp reaches the static limit a nanosecond after a frame, so that the error of the slide is not the luck of the
/// onset within a sub-step.
closed_form::SliderOscillator ramp() {
  closed_form::SliderOscillator o{.mass = 0.2, .stiffness = 4000, .damping = 16, .friction = {0.6, 0.4}};
  o.normal_force.constant = o.mass * 9.81;
  o.force.rate = o.friction.mu_static * o.normal_force.constant / (53.0 / 90 + 1e-9);
  start_in_forced_stick(o);
  return o;
}

}  // namespace

Case load_ramp_case() {
  const auto o = ramp();
  const double end = 65.0 / 90;
  const SliderClaims expect(o, end, along, samples);
  Run run{.name = "pulled", .problem = [=] { return palm_scene("C04 load ramp", o, {.samples = samples}, end); }};
  Claim slip = expect.slip(end, "slip at t = 65/90 s");
  slip.converges = true;
  run.claims = {expect.breakaway(1, "onset"), slip, expect.speed(end, "speed at t = 65/90 s")};
  run.curve = expect.curve("slip [m]");
  return {
      .id = "C04",
      .title = "Breakaway under a linear load ramp",
      .truth_level = "L2",
      .statement = "A 0.2 kg block on a palm is pulled with F = r t, r = 2.0 N/s; mu_s = 0.6, mu_d = 0.4.",
      .formula =
          "t_s = mu_s m g / r; L1: x = (mu_s - mu_d) g tau^2 / 2 + r tau^3 / (6 m); L2: + the springs' own r t / K "
          "before the onset and its speed r / K after it",
      .note =
          "K = 4000 N/m, C = 16 N s/m, 8 samples, started on the creep of the loaded springs. The onset is that of L1.",
      .runs = {run}};
}

}  // namespace handhold::catalogue
