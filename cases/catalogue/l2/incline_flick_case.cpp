// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 8;
constexpr double speed = 1;  // v0 [m/s]
const Eigen::Vector3d up_hill = Eigen::Vector3d::UnitX();

/// Critically damped (C = 2 √(K m)): the springs, loaded by friction when the block stops, swing back without carrying
/// a block away that rigid friction would hold.
closed_form::SliderOscillator flick(double slope) {
  closed_form::SliderOscillator o{.mass = 0.2, .stiffness = 3200, .damping = 50, .friction = {0.5, 0.4}};
  o.normal_force.constant = o.mass * 9.81 * std::cos(slope);
  o.force.constant = -o.mass * 9.81 * std::sin(slope);
  o.v = speed;
  o.direction = 1;
  o.stretch = o.friction.mu_dynamic * o.normal_force.constant / o.stiffness;
  return o;
}

Run run_of(const std::string& name, double slope) {
  const auto o = flick(slope);
  return {.name = name, .problem = [=] { return palm_scene("C02 " + name, o, {.samples = samples}, 0.3); }};
}

Run returning_run() {
  Run run = run_of("comes back, th = 0.6", 0.6);
  const SliderClaims expect(flick(0.6), 0.3, up_hill, samples);
  Claim mid = expect.slip(9.0 / 90, "slip at t = 0.1 s, still going up");
  mid.converges = true;
  run.claims = {expect.restick(1, "turns back"),
                expect.slip_at_restick(1, "height of the turn"),
                mid,
                expect.breakaway(1, "slides down again"),
                expect.slip(27.0 / 90, "place at t = 0.3 s"),
                expect.speed(27.0 / 90, "speed at t = 0.3 s")};
  run.curve = expect.curve("slip up the palm [m]");
  return run;
}

Run holding_run() {
  Run run = run_of("stays up, th = 0.3", 0.3);
  const SliderClaims expect(flick(0.3), 0.3, up_hill, samples);
  run.claims = {expect.restick(1, "stops"), expect.slip_at_restick(1, "height of the stop"),
                expect.slip(27.0 / 90, "rest, t = 0.3 s"),
                yes_or_no("never slides again", expect.truth().events().size() == 1,
                          "L2: the springs swing back within the static cone", none_of(EventKind::breakaway))};
  return run;
}

}  // namespace

Case incline_flick_case() {
  return {.id = "C02",
          .title = "Incline: slides up, stops, comes back or stays",
          .truth_level = "L2",
          .statement = "A 0.2 kg block is flicked up a tilted palm with 1 m/s; mu_s = 0.5, mu_d = 0.4.",
          .formula =
              "L1: t_up = v0 / (g (sin th + mu_d cos th)), D = v0 t_up / 2; comes back iff tan th > mu_s. "
              "L2: the same way up; then the springs swing from mu_d N to the other side of the cone",
          .note =
              "K = 3200 N/m, C = 50 N s/m (critical), 8 samples, rotation locked. L1 for th = 0.6: t_up = 0.113924 s, "
              "D = 56.962 mm, equal to L2 up to the stop.",
          .runs = {returning_run(), holding_run()}};
}

}  // namespace handhold::catalogue
