// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <complex>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/builders/slider_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 16;  // of both fingers
constexpr double gravity = 9.81, normal_force = 2.6, mu = 0.5;
const Eigen::Vector3d sideways = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitZ();

/// Stuck, the two directions do not know of each other: the weight loads the springs at rest, the shaking moves them as
/// an oscillator whose cone is what the weight leaves of it, sqrt((2 μ N)² − (m g)²).
closed_form::SliderOscillator shaken(double amplitude) {
  closed_form::SliderOscillator o{.mass = 0.2, .stiffness = 6400, .damping = 32};
  o.normal_force.constant = 2 * normal_force;
  const double left = std::sqrt(std::pow(2 * mu * normal_force, 2) - std::pow(o.mass * gravity, 2));
  o.friction = {left / o.normal_force.constant, left / o.normal_force.constant};
  o.base = {.amplitude = amplitude, .frequency = 15};
  start_in_forced_stick(o);
  return o;
}

double critical_amplitude() {
  const auto o = shaken(1);
  const double w = o.base.frequency;
  const std::complex<double> spring{o.stiffness, o.damping * w};
  const double gain = std::abs(spring / (spring - o.mass * w * w));
  return o.friction.mu_static * o.normal_force.constant / o.mass / (w * w * gain);
}

Scene scene(double amplitude, double duration) {
  const auto o = shaken(amplitude);
  Scene scene;
  scene.name = "D06 pinch shaken sideways";
  scene.duration = duration;
  scene.contact = {.stiffness = o.stiffness / samples, .damping = o.damping / samples};
  Body body = block({edge, edge, edge}, voxel, o.mass, {mu, mu});
  body.mobility = Mobility::translation;  // the weight off the fingers' line would turn a free block
  const double sag = o.mass * gravity / o.stiffness;
  body.X_WO.p = o.x * sideways;
  body.V_WO.v = o.v * sideways;
  scene.bodies = {body};
  const closed_form::Drive base = o.base;
  const Path path = [base](double t) -> Eigen::Vector3d { return base.value(t) * sideways; };
  const auto no_grip = [](double) { return 0.0; };
  const SampleStart start{.lag_W = sag * up - o.stretch * sideways};
  scene.hands = {hand_of(pinch_patches(edge / 2, 2 * normal_force / o.stiffness, start, no_grip, path), duration)};
  return scene;
}

Run slipping_run() {
  const double end = 0.1;
  const SliderClaims expect(shaken(0.05), end, sideways, samples);
  Run run{.name = "slips", .problem = [=] { return scene(0.05, end); }};
  run.claims = {expect.breakaway(1, "onset"), expect.slip(4.0 / 90, "lag of the springs at t = 4/90 s"),
                expect.speed(4.0 / 90, "speed against the hand at t = 4/90 s")};
  return run;
}

Run threshold_run(double share) {
  const double amplitude = share * critical_amplitude(), end = 0.85;  // two periods
  return near_threshold(
      share, [=] { return scene(amplitude, end); },
      yes_or_no("holds", share < 1, "L2: sqrt(g^2 + (A w^2 |H|)^2) <= 2 mu_s N/m", none_of(EventKind::breakaway)));
}

}  // namespace

Case sideways_pinch_case() {
  return {
      .id = "D06",
      .title = "Pinch shaken sideways in the finger plane: round cone",
      .truth_level = "L2",
      .statement =
          "A 0.2 kg cube between two fingers that press with 2.6 N each and move as 50 mm sin(15 t) at right angles "
          "to gravity; mu = 0.5.",
      .formula =
          "L1: holds iff sqrt(g^2 + (A w^2)^2) <= c = 2 mu_s N/m; onset sin(w t) = sqrt(c^2 - g^2)/(A w^2). "
          "L2: A w^2 times |H|, H = (K + i C w)/(K + i C w - m w^2), and its phase",
      .note =
          "K = 6400 N/m, C = 32 N s/m of 2 x 8 samples, started in the forced motion, springs at the weight. L1: onset "
          "0.057374 s. A pyramid for a cone would hold 1.5 times the amplitude.",
      .runs = {slipping_run(), threshold_run(0.98), threshold_run(1.02)}};
}

}  // namespace handhold::catalogue
