// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/palm_lift.hpp"

namespace handhold::catalogue {
namespace {

constexpr double stiff = 1000, soft = 100;  // [N/m] per sample
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
const std::string slow_crossing =
    "the springs unload at 6 mm/s only, so the event time magnifies an error of the depth";

closed_form::PalmLift lift(double amplitude, double stiffness = stiff) {
  return {.amplitude = amplitude, .frequency = 18, .gravity = 9.81, .mass = 0.2, .stiffness = 8 * stiffness};
}

Scene scene(const closed_form::PalmLift& l, double duration) {
  Scene scene;
  scene.name = fmt::format("D13 palm lift {:.6g} m", l.amplitude);
  scene.duration = duration;
  scene.contact = {.stiffness = l.stiffness / 8, .damping = 0};
  Body body = block({edge, edge, edge}, voxel, l.mass, {});
  body.X_WO.p.z() = edge / 2 - start_depth(l);
  body.V_WO.v = start_velocity(l) * up;
  scene.bodies = {body};
  const Path path = [l](double t) -> Eigen::Vector3d { return l.amplitude * std::sin(l.frequency * t) * up; };
  scene.hands = {hand_of({palm_patch({}, path)}, duration)};
  return scene;
}

/// Height of the object above the hand's own motion: what is measured relative to the phalanx.
double relative_height(const closed_form::PalmLift& l, double t) {
  return height(l, t) - l.amplitude * std::sin(l.frequency * t);
}

Run flight_run() {
  const closed_form::PalmLift l = lift(0.05);
  const double duration = 24.0 / 90;  // just past the landing
  Run run{.name = "leaves and lands", .problem = [=] { return scene(l, duration); }};
  const double flight = landing(l) - lift_off(l);
  const double closing_acceleration = l.gravity - l.amplitude * 18 * 18 * std::sin(18 * landing(l));
  run.claims = {
      claim("lift-off", lift_off(l), "L2: sin(w t1) = g/(A w^2) (1 - w^2/W^2), W^2 = K/m", time_of(EventKind::release),
            controlled_limit(10, slow_crossing),
            event_limit(3.25,
                        "the implicit step loads the springs one step late, and rings from the start by 1.25 as much")),
      claim("landing", landing(l), "L2: root of flight(t) = A sin w t", time_of(EventKind::touch), controlled_limit(),
            event_limit(1 + 1.5 * l.gravity * flight / -landing_speed(l),
                        "the height is off by up to 1.5 g h over the flight")),
      claim("landing speed", landing_speed(l), "L2: y' - A w cos w t at the landing",
            {.kind = Measure::Kind::speed, .event = EventKind::touch, .axis = up}, controlled_limit(10, slow_crossing),
            {.per_step = 2 * closing_acceleration,
             .reason =
                 "launched and landed up to one sub-step late each, times the closing acceleration; at frames longer "
                 "than 1/90 s the hand's path between frames adds to it and the gate fails"})};
  run.curve = Curve{"height above the hand [m]", {.kind = Measure::Kind::displacement, .axis = up}, [l](double t) {
                      return t < landing(l) ? relative_height(l, t) : std::nan("");
                    }};
  return run;
}

/// Soft springs, resolved by the sub-step (Ω h < 0.1 from the first refinement on): there the order shows.
Run order_run() {
  const closed_form::PalmLift l = lift(0.05, soft);
  const double mid = 12.0 / 90;  // in flight, on a frame
  const double flown = mid - lift_off(l);
  Run run{.name = "leaves, k = 100 N/m", .problem = [=] { return scene(l, mid); }};
  run.claims = {claim("height above the hand at t = 2/15 s", relative_height(l, mid),
                      "L2: flight from lift-off, less A sin w t", displacement_at(mid, up), controlled_limit(),
                      {.per_step = 1.5 * l.gravity * flown,
                       .reason = "launch speed off by up to g h, over the flight, + half a sub-step of bias (R03)"},
                      /*converges=*/true)};
  return run;
}

/// Amplitude at `share` of the one that lifts off; two periods.
Run threshold_run(double share) {
  closed_form::PalmLift l = lift(1);
  const double softness = l.frequency * l.frequency * l.mass / l.stiffness;
  l.amplitude = share * l.gravity * (1 - softness) / (l.frequency * l.frequency);
  const double duration = 0.7;
  return near_threshold(
      share, [=] { return scene(l, duration); },
      yes_or_no("stays on the hand", !leaves(l), "L2: leaves iff A w^2 > g (1 - w^2/W^2)",
                none_of(EventKind::release)));
}

}  // namespace

Case palm_lift_case() {
  return {
      .id = "D13",
      .title = "Palm lift: contact loss and landing under vertical oscillation",
      .truth_level = "L2",
      .statement = "A 0.2 kg cube rests on a flat hand that moves up and down as y = 50 mm sin(18 t).",
      .formula =
          "L1: leaves iff A w^2 > g, sin(w t1) = g/(A w^2), lands where the flight meets A sin w t. "
          "L2: the same with g/(A w^2) (1 - w^2/W^2) and the launch speed A w cos w t1 / (1 - w^2/W^2), W^2 = K/m",
      .note =
          "Judged against the L2 closed form at k = 1000 N/m a sample (K = 8000 N/m, w^2/W^2 = 0.81 %), undamped, "
          "started "
          "in the forced oscillation without transient. L1: lift-off 0.036137 s, landing 0.256274 s, -1.353956 m/s.",
      .runs = {flight_run(), order_run(), threshold_run(0.98), threshold_run(1.02)}};
}

}  // namespace handhold::catalogue
