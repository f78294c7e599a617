// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/pinch.hpp"

namespace handhold::catalogue {
namespace {

constexpr double stiffness = 100;
constexpr double finger_stiffness = 8 * stiffness;
const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();

closed_form::PinchOpening opening(double normal_force) {
  return {.mass = 0.05,
          .normal_force = normal_force,
          .rate = 10,
          .gravity = 9.81,
          .friction = {.mu_static = 0.8, .mu_dynamic = 0.4}};
}

/// The grip whose slip starts on a frame, so that the error of the fall is not the luck of the onset within a sub-step:
/// a nanosecond after it, so that rounding has no say in whether that frame still sticks.
closed_form::PinchOpening opening_on_frame() {
  closed_form::PinchOpening o = opening(0);
  o.normal_force = o.mass * o.gravity / (2 * o.friction.mu_static) + o.rate * (10.0 / 90 + 1e-9);
  return o;
}

Scene scene(const closed_form::PinchOpening& o, double duration) {
  Scene scene;
  scene.name = "D02 pinch opening";
  scene.duration = duration;
  scene.contact = {.stiffness = stiffness, .damping = 0};  // a damper would add c d' to the ramp of N
  const double load = o.mass * o.gravity / (2 * finger_stiffness);
  scene.bodies = {block({edge, edge, edge}, voxel, o.mass, o.friction)};
  const double speed = o.rate / finger_stiffness;
  const auto opens = [speed](double t) { return -speed * t; };
  const Path still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  const auto patches =
      pinch_patches(edge / 2, o.normal_force / finger_stiffness, {.lag_W = -load * down}, opens, still);
  scene.hands = {hand_of(patches, duration)};
  return scene;
}

Run catalogue_run() {
  const closed_form::PinchOpening o = opening(1.5);
  const double end = 0.2;
  Run run{.name = "opens", .problem = [=] { return scene(o, end); }};
  const double opened = 14.0 / 90;  // the first frame with empty fingers
  run.claims = {
      claim("slip onset", slip_onset(o), "L1 = L2: t_s = (N0 - m g / (2 mu_s)) / r", time_of(EventKind::breakaway),
            controlled_limit(), event_limit()),
      claim("release", open_time(o), "L1 = L2: t_open = N0 / r", time_of(EventKind::release), controlled_limit(),
            event_limit()),
      claim("fall just after the fingers open", fall(o, opened),
            "L1 = L2: g (1 - mu_d/mu_s) tau^2/2 + mu_d r tau^3/(3 m)", displacement_at(opened, down),
            controlled_limit(),
            {.per_step = 1.51 * fall_speed(o, opened),
             .reason = "onset seen up to one sub-step late, times the speed, + half a sub-step of bias (R03)"}),
      claim("fall at t = 0.2 s", fall(o, end), "L1 = L2, free fall after t_open", displacement_at(end, down),
            controlled_limit(),
            {.per_step = 1.51 * fall_speed(o, end), .reason = "as above, at the speed of the end"})};
  run.curve =
      Curve{"fall [m]", {.kind = Measure::Kind::displacement, .axis = down}, [o](double t) { return fall(o, t); }};
  return run;
}

Run order_run() {
  const closed_form::PinchOpening o = opening_on_frame();
  const double t = 12.0 / 90;  // slipping, fingers not yet open
  Run run{.name = "opens, onset on a frame", .problem = [=] { return scene(o, t); }};
  run.claims = {claim("fall at t = 2/15 s", fall(o, t), "L1 = L2, as above", displacement_at(t, down),
                      controlled_limit(),
                      {.per_step = 1.51 * fall_speed(o, t),
                       .reason = "onset seen up to one sub-step late, + half a sub-step of bias (R03)"},
                      /*converges=*/true)};
  return run;
}

}  // namespace

Case pinch_opening_case() {
  return {
      .id = "D02",
      .title = "Pinch opening on a linear ramp: slip onset and fall",
      .truth_level = "L1",
      .statement = "A 50 g cube between thumb and index; N(t) = 1.5 N - 10 N/s t; mu_s = 0.8, mu_d = 0.4.",
      .formula =
          "t_s = (N0 - m g / (2 mu_s)) / r; z = g (1 - mu_d/mu_s) tau^2/2 + mu_d r tau^3/(3 m); free fall from N0 / r",
      .note =
          "k = 100 N/m (the paper's gamma), no damping, 2 x 8 samples. The springs start at the load m g, so the onset "
          "is "
          "that of L1, and kinetic friction is mu_d N(t) in both.",
      .runs = {catalogue_run(), order_run()}};
}

}  // namespace handhold::catalogue
