// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/pinch.hpp"

namespace handhold::catalogue {
namespace {

constexpr double stiffness = 100;  // the paper's γ, per sample
constexpr double finger_stiffness = 8 * stiffness;
const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();

closed_form::Pinch pinch(double normal_force) {
  return {.fingers = 2,
          .normal_force = normal_force,
          .mass = 0.2,
          .acceleration = 1,
          .gravity = 9.81,
          .friction = {.mu_static = 0.5, .mu_dynamic = 0.4}};
}

/// The hand comes along the parabola ½ a t², at rest at t = 0; the springs start at the load m (g + a), or, to slide at
/// once, at the lag of breakaway (at the kinetic lag they would stick).
Scene scene(const closed_form::Pinch& p, double duration, bool sliding) {
  Scene scene;
  scene.name = fmt::format("D01 pinch with {:.6g} N", p.normal_force);
  scene.duration = duration;
  scene.contact = {.stiffness = stiffness, .damping = 0.5};
  const double depth = p.normal_force / finger_stiffness;
  const double load = p.mass * (p.gravity + p.acceleration) / (2 * finger_stiffness);
  const double lag = sliding ? p.friction.mu_static * depth : load;
  scene.bodies = {block({edge, edge, edge}, voxel, p.mass, p.friction)};
  const double a = p.acceleration;
  const Path path = [a](double t) -> Eigen::Vector3d { return 0.5 * a * t * t * Eigen::Vector3d::UnitZ(); };
  const auto no_grip = [](double) { return 0.0; };
  scene.hands = {
      hand_of(pinch_patches(edge / 2, depth, {.lag_W = -lag * down, .slipping = sliding}, no_grip, path), duration)};
  return scene;
}

Run slipping_run() {
  const closed_form::Pinch p = pinch(2);
  const double t = 0.1;
  Run run{.name = "N = 2 N slips", .problem = [=] { return scene(p, t, true); }};
  const double change = 2 * slip(p, t) / t - p.acceleration * t;  // of the object's own speed; the hand's path is exact
  run.claims = {claim("slip after 0.1 s", slip(p, t), "L1 = L2: (g + a - 2 mu_d N / m) T^2 / 2",
                      displacement_at(t, down), controlled_limit(), euler_bias_limit(change), /*converges=*/true)};
  run.curve =
      Curve{"slip [m]", {.kind = Measure::Kind::displacement, .axis = down}, [p](double s) { return slip(p, s); }};
  return run;
}

/// Grip at `share` of the critical normal force.
Run threshold_run(double share) {
  const double critical = critical_normal_force(pinch(1));
  const closed_form::Pinch p = pinch(share * critical);
  const double duration = 11.0 / 90;  // at 0.98 it slips 17 mm of the 31 mm that the fingers have
  const double level = 0.5 * slip(pinch(0.98 * critical), duration);
  return near_threshold(
      share, [=] { return scene(p, duration, false); },
      yes_or_no("holds", holds(p), "L1 = L2: n mu_s N >= m (g + a)",
                {.kind = Measure::Kind::held, .axis = down, .level = level}));
}

}  // namespace

Case pinch_case() {
  return {
      .id = "D01",
      .title = "Pinch hold threshold under vertical hand acceleration",
      .truth_level = "L1",
      .statement =
          "A 0.2 kg cube between thumb and index, each pressing with N; the hand accelerates up with 1 m/s^2; "
          "mu_s = 0.5, mu_d = 0.4.",
      .formula = "holds iff 2 mu_s N >= m (g + a); else slips (g + a - 2 mu_d N / m) T^2 / 2",
      .note =
          "k = 100 N/m (the paper's gamma), c = 0.5 N s/m, 2 x 8 samples. The springs start at the load of the "
          "acceleration, so that L2 moves exactly as L1; started unstretched they would overshoot to twice the load.",
      .runs = {slipping_run(), threshold_run(0.98), threshold_run(1.02)}};
}

}  // namespace handhold::catalogue
