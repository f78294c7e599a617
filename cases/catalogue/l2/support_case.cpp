// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr double speed = 0.1, spin = 5;  // [m/s], [rad/s]
const Eigen::Vector3d along = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitZ();

Scene scene(double duration) {
  Scene scene;
  scene.name = "H10 support";
  scene.duration = duration;
  Body body = block({edge, edge, edge}, voxel, 0.2, {0.5, 0.5});
  body.V_WO = {spin * up, speed * along};
  body.held_until = 1;
  scene.bodies = {body};
  return scene;
}

/// (1 + h/τ)^(−n) against e^(−t/τ): e^(−t/τ) t h/(2 τ²) of the way v τ to first order.
Limit braked_limit(double way, double t) {
  return {.per_step = 2 * way * std::exp(-t / support_time) * t / (2 * support_time * support_time),
          .reason = "the implicit step brakes with (1 + h/tau)^-n: twice e^(-t/tau) t h/(2 tau^2) of the whole way"};
}

Claim braked(const std::string& quantity, double start, Measure::Kind kind, double t) {
  const double way = start * support_time;
  return claim(quantity, way * -std::expm1(-t / support_time), "L1 = L2: tau v (1 - e^(-t/tau))",
               {.kind = kind, .axis = kind == Measure::Kind::rotation ? up : along, .at = t}, controlled_limit(),
               braked_limit(way, t));
}

}  // namespace

Case support_case() {
  const double end = 4.0 / 90;
  Run run{.name = "brakes", .problem = [=] { return scene(end); }};
  run.claims = {braked("angle", spin, Measure::Kind::rotation, end),
                braked("way", speed, Measure::Kind::displacement, end),
                {.quantity = "sag",
                 .unit = "m",
                 .truth = 0,
                 .source = "L1 = L2: it carries the weight",
                 .measure = displacement_at(end, up),
                 .controlled = absolute_controlled_limit(),
                 .stepped = {.value = 5e-15, .reason = "no force at all: rounding of places of a metre"},
                 .scale = speed * support_time}};
  return {.id = "H10",
          .title = "A support brakes what it carries",
          .truth_level = "L1 = L2",
          .statement = "A body on a support moves with 0.1 m/s and spins with 5 rad/s.",
          .formula = "m v' = -m v/tau, I w' = -I w/tau, tau = 10 ms; no weight",
          .note = "The support is the one that holds an object up while a hand closes.",
          .runs = {run}};
}

}  // namespace handhold::catalogue
