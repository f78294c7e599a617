// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/spin_stop.hpp"

namespace handhold::catalogue {
namespace {

const Eigen::Vector3d axis = Eigen::Vector3d::UnitY();

Scene scene(const closed_form::SpinStop& s, double duration) {
  Scene scene;
  scene.name = fmt::format("G09 spin {:.6g} rad/s", s.spin);
  scene.duration = duration;
  scene.gravity.setZero();
  scene.contact = {.stiffness = s.stiffness / 8, .damping = 0};
  Body body = block({edge, edge, edge}, voxel, 0.2, s.friction);
  body.inertia.about_center = s.inertia * Eigen::Matrix3d::Identity();
  body.V_WO.w = s.spin * axis;
  scene.bodies = {body};
  const Path still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  const auto no_grip = [](double) { return 0.0; };
  scene.hands = {hand_of(pinch_patches(edge / 2, s.normal_force / s.stiffness, {}, no_grip, still), duration)};
  return scene;
}

Run slipping_run() {
  const closed_form::SpinStop s{.stiffness = 8000, .spin = 5, .friction = {.mu_static = 0.5, .mu_dynamic = 0.4}};
  const double after = 9.0 / 90;  // 20 ms after the stop
  Run run{.name = "5 rad/s slips", .problem = [=] { return scene(s, after); }};
  // The springs' torque grows from 0 within two sub-steps; taken at their ends it brakes up to h/2 too early.
  const std::string ramp = "the ramp of the torque is felt up to half a sub-step early";
  Limit followed = controlled_limit(250, "an anchor is known to 1e-10 m, on a ring of 4 mm");
  const double ring = residual_amplitude(s), frequency = residual_frequency(s);
  const double swung = after - restick_time(s);
  run.claims = {
      claim("slip onset", breakaway_time(s), "L2: pendulum with W^2 = 2 K a^2/I to the chord 2 a sin(th/2) = mu_s N/K",
            time_of(EventKind::breakaway), followed, event_limit(1.5, ramp)),
      claim("stop time", restick_time(s), "L2: t1 + integral of I dw/(T cos psi(w))", time_of(EventKind::restick),
            followed, event_limit(1.5, ramp)),
      claim("angle at the stop", restick_angle(s), "L2: int T cos psi dth = I w1^2/2 on the curve of pursuit",
            rotation_when(EventKind::restick, axis), followed,
            {.per_step = 1.02 * s.spin,
             .reason = "half a sub-step of bias (R03) + half a sub-step of early braking, times the spin, + 2 %"}),
      claim("angle at t = 0.1 s", angle(s, after), "L2: pendulum with W^2 = 2 K a b/I about the anchors",
            rotation_at(after, axis), followed,
            {.per_step = 1.02 * s.spin + 1.5 * ring * frequency + implicit_ring_limit(ring, frequency, swung).per_step,
             .reason = "as at the stop, + the oscillation's start up to 1.5 sub-steps off, + its damping"})};
  return run;
}

/// Slow springs: a quarter of a period is 160 sub-steps, in which the implicit step takes 0.8 % of the amplitude.
closed_form::SpinStop slow(double share) {
  closed_form::SpinStop s{.inertia = 2e-3, .stiffness = 800, .friction = {.mu_static = 0.5, .mu_dynamic = 0.4}};
  s.spin = share * critical_spin(s);
  return s;
}

Run threshold_run(double share) {
  const closed_form::SpinStop s = slow(share);
  const double end = 0.6;
  Run run = near_threshold(
      share, [=] { return scene(s, end); },
      yes_or_no("sticks", share < 1, "L2: sticks iff a w0/W <= mu_s N/K", none_of(EventKind::breakaway)));
  if (share > 1) return run;
  const double t = 36.0 / 90;
  run.claims.push_back(
      claim("angle at t = 0.4 s", angle(s, t), "L2: sin(th/2) = kappa sn(W t, kappa), kappa = w0/(2 W)",
            rotation_at(t, axis), controlled_limit(),
            implicit_ring_limit(s.spin / torsional_frequency(s), torsional_frequency(s), t), /*converges=*/true));
  run.curve = Curve{
      "angle [rad]", {.kind = Measure::Kind::rotation, .axis = axis}, [s](double time) { return angle(s, time); }};
  return run;
}

}  // namespace

Case spin_stop_case() {
  return {.id = "G09",
          .title = "Spinning object stopped by two compliant ring patches",
          .truth_level = "L2",
          .statement =
              "An object of 1e-4 kg m^2 spins at 5 rad/s between two rings of 4 mm radius and slack springs; N = 2 N, "
              "mu_s = 0.5, mu_d = 0.4, no gravity.",
          .formula =
              "small angles: slip angle (I w0^2 - T th_c)/(2 T), th_c = T/(2 K a^2), then oscillation of th_c; exact: "
              "pendulum, curve of pursuit, pendulum",
          .note =
              "k = 1000 N/m a sample, undamped; mu_s > mu_d, so that the oscillation that is left stays off its cone. "
              "Threshold runs: I = 2e-3 kg m^2, k = 100 N/m (W = 3.6 rad/s).",
          .runs = {slipping_run(), threshold_run(0.98), threshold_run(1.02)}};
}

}  // namespace handhold::catalogue
