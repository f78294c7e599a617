// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/incline.hpp"

namespace handhold::catalogue {
namespace {

constexpr double mass = 0.2;
constexpr double stiffness = 500;  // [N/m] per sample: 0.43 mm deep
constexpr double distance = 0.1;   // D [m]
constexpr Friction friction{.mu_static = 0.5, .mu_dynamic = 0.4};
const Eigen::Vector3d down_hill = Eigen::Vector3d::UnitX();

closed_form::Incline incline(double slope) { return {.slope = slope, .gravity = 9.81, .friction = friction}; }

/// The palm stays level and gravity leans by θ. The springs start at the load of rest or, to slide at once, at the lag
/// of breakaway (at the kinetic lag they would stick).
Scene scene(double slope, double duration, bool sliding) {
  Scene scene;
  scene.name = fmt::format("C01 incline {:.6g} rad", slope);
  scene.duration = duration;
  scene.gravity = 9.81 * Eigen::Vector3d(std::sin(slope), 0, -std::cos(slope));
  scene.contact = {.stiffness = stiffness, .damping = 0.5};
  const double depth = mass * -scene.gravity.z() / (8 * stiffness);
  const double lag = sliding ? friction.mu_static * depth : mass * scene.gravity.x() / (8 * stiffness);

  Body body = block({5 * edge, edge, edge / 2}, 2 * voxel, mass, friction);
  body.mobility = Mobility::translation;  // a point mass: no tipping in this case
  body.X_WO.p.z() = edge / 4 - depth;
  scene.bodies = {body};
  const auto still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  scene.hands = {hand_of({palm_patch({.lag_W = -lag * down_hill, .slipping = sliding}, still)}, duration)};
  return scene;
}

Run sliding_run(double slope) {
  const closed_form::Incline truth = incline(slope);
  const double t = 36.0 / 90;  // ends on a frame, just past D
  const double a = acceleration(truth);
  const double v = speed_at(truth, distance);
  Run run{.name = "slides", .problem = [=] { return scene(slope, t, true); }};
  run.claims = {
      claim("time to slide 0.1 m", time_at(truth, distance), "L1 = L2: t = sqrt(2 D / a), a = g (sin th - mu_d cos th)",
            {.kind = Measure::Kind::time_at_displacement, .axis = down_hill, .level = distance}, controlled_limit(),
            {.per_step = 0.51, .reason = "the bias a t h / 2 of the distance (R03) over the speed a t"}),
      claim("speed at t = 0.4 s", a * t, "L1 = L2: v = a t", speed_at(t, down_hill), controlled_limit(),
            {.value = 1e-12 * v, .reason = "exact for a constant force (R03): rounding"}),
      claim("slip at t = 0.4 s", slip(truth, t), "L1 = L2: x = a t^2 / 2", displacement_at(t, down_hill),
            controlled_limit(), euler_bias_limit(a * t), /*converges=*/true)};
  run.curve = Curve{"slip [m]", {.kind = Measure::Kind::displacement, .axis = down_hill}, [truth](double s) {
                      return slip(truth, s);
                    }};
  return run;
}

/// tan θ = `share` of mu_s.
Run threshold_run(double share) {
  const double slope = std::atan(share * friction.mu_static);
  const double duration = 0.3;
  const bool truth = holds(incline(slope));
  // Slipping, it moves further than this by far; sticking, only its springs could give way, by the lag.
  const double level = 0.5 * slip(incline(std::atan(1.02 * friction.mu_static)), duration);
  return near_threshold(
      share, [=] { return scene(slope, duration, false); },
      yes_or_no("holds", truth, "L1 = L2: tan th <= mu_s",
                {.kind = Measure::Kind::held, .axis = down_hill, .level = level}));
}

}  // namespace

Case incline_case() {
  return {.id = "C01",
          .title = "Incline: stick threshold, slide time and speed",
          .truth_level = "L1",
          .statement = "A 0.2 kg block on a palm tilted by th = 0.5 rad is let go; mu_s = 0.5, mu_d = 0.4.",
          .formula = "holds iff tan th <= mu_s; else a = g (sin th - mu_d cos th), t = sqrt(2 D / a), v = sqrt(2 a D)",
          .note =
              "k = 500 N/m, c = 0.5 N s/m, 8 samples, rotation locked. Started at rest and slipping, normal force and "
              "kinetic "
              "friction never change, so the compliant element (L2) moves exactly as L1.",
          .runs = {sliding_run(0.5), threshold_run(0.98), threshold_run(1.02)}};
}

}  // namespace handhold::catalogue
