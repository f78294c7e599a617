// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/stopping.hpp"

namespace handhold::catalogue {
namespace {

constexpr double stiffness = 500, damping = 0.5;  // per sample
constexpr int samples = 8;
constexpr Friction friction{.mu_static = 0.5, .mu_dynamic = 0.4};
const Eigen::Vector3d along = Eigen::Vector3d::UnitX();

closed_form::Stopping stopping() {
  return {.speed = 0.8,
          .mu_dynamic = friction.mu_dynamic,
          .gravity = 9.81,
          .mass = 0.2,
          .stiffness = samples * stiffness,
          .damping = samples * damping};
}

Scene scene(double duration) {
  const closed_form::Stopping s = stopping();
  Scene scene;
  scene.name = "C03 sliding stop";
  scene.duration = duration;
  scene.contact = {.stiffness = stiffness, .damping = damping};
  const double depth = s.mass * s.gravity / s.stiffness;
  Body body = block({5 * edge, edge, edge / 2}, 2 * voxel, s.mass, friction);
  body.mobility = Mobility::translation;
  body.X_WO.p.z() = edge / 4 - depth;
  body.V_WO.v = s.speed * along;
  scene.bodies = {body};
  const auto still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  const SampleStart start{.lag_W = -s.mu_dynamic * depth * along, .slipping = true};
  scene.hands = {hand_of({palm_patch(start, still)}, duration)};
  return scene;
}

}  // namespace

Case stopping_case() {
  const closed_form::Stopping s = stopping();
  const double duration = 0.5;
  const double mid = 15.0 / 90;  // in the slide, on a frame
  // What is left of the ring-down at the end; the phase that a stepped method gives it is anyone's guess.
  const double swing =
      (stop_distance(s) - rest_distance(s)) * std::exp(-s.damping / (2 * s.mass) * (duration - stop_time(s)));
  Run run{.name = "stops", .problem = [=] { return scene(duration); }};
  run.claims = {
      claim("stop time", stop_time(s), "L1 = L2: t = v0 / (mu_d g)", time_of(EventKind::restick), controlled_limit(),
            event_limit()),
      claim("slip at the stop", stop_distance(s), "L1 = L2: D = v0^2 / (2 mu_d g)",
            displacement_when(EventKind::restick, along), controlled_limit(), euler_bias_limit(s.speed)),
      claim("slip at t = 1/6 s", distance(s, mid), "L1 = L2: x = v0 t - mu_d g t^2 / 2", displacement_at(mid, along),
            controlled_limit(), euler_bias_limit(s.mu_dynamic * s.gravity * mid), /*converges=*/true),
      claim("place at t = 0.5 s", distance(s, duration),
            "L2: D - rho + rho exp(-delta tau) (cos w tau + delta/w sin w tau), rho = mu_d m g / K",
            displacement_at(duration, along), controlled_limit(10, "the phase of the ring-down adds to the stop"),
            {.value = 2 * swing,
             .per_step = 0.51 * s.speed,
             .reason = "bias at the stop (R03) + twice the swing of the springs, rho exp(-delta tau), that is left"})};
  run.curve =
      Curve{"slip [m]", {.kind = Measure::Kind::displacement, .axis = along}, [s](double t) { return distance(s, t); }};
  return {.id = "C03",
          .title = "Sliding stop on a level palm",
          .truth_level = "L1",
          .statement = "A 0.2 kg block slides at 0.8 m/s on a palm at rest; mu_d = 0.4.",
          .formula = "t = v0 / (mu_d g), D = v0^2 / (2 mu_d g)",
          .note =
              "k = 500 N/m, c = 0.5 N s/m, 8 samples, rotation locked. The slide is the same in L1 and L2; after the "
              "stop the "
              "loaded springs push the block back by mu_d m g / K = 0.196 mm (L2 only).",
          .runs = {run}};
}

}  // namespace handhold::catalogue
