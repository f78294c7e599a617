// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/planar_scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::PlanarSlide;
using closed_form::PlanarState;
using Eigen::Vector2d;

constexpr double mass = 0.1, arm = 0.05, pivot_inertia = 4e-4, gravity = 9.81, start = 1.2;
constexpr double stiffness = 5000;  // per sample
constexpr double radius = 0.004, friction = 0.5;
const double frequency = std::sqrt(mass * gravity * arm / pivot_inertia);
const Eigen::Vector3d axis = Eigen::Vector3d::UnitY(), down = -Eigen::Vector3d::UnitZ();

Vector2d hanging(double angle) { return {-std::cos(angle), -std::sin(angle)}; }
Vector2d swinging(double angle) { return {std::sin(angle), -std::cos(angle)}; }

/// Held at one place by a sample of each finger, which carries at t = 0 what a rigid pivot would.
PlanarSlide pendulum(double angle, double spin, double friction_torque) {
  const double acceleration =
      (-mass * gravity * arm * std::sin(angle) - std::copysign(friction_torque, spin)) / pivot_inertia;
  PlanarSlide s{.mass = mass,
                .inertia = pivot_inertia - mass * arm * arm,
                .gravity = {-gravity, 0},
                .angle = angle,
                .spin = spin};
  const Vector2d of_center = arm * (acceleration * swinging(angle) - spin * spin * hanging(angle));
  const Vector2d lag = mass * (of_center - s.gravity) / (2 * stiffness);
  s.sticking = {{.p = Vector2d::Zero(), .anchor_B = {arm, 0}, .stiffness = 2 * stiffness}};
  s.center = -lag + arm * hanging(angle);
  s.velocity = spin * arm * swinging(angle);
  return s;
}

PlanarLayout layout(double mu_static) {
  return {.center_B = {-arm, 0},
          .stiffness = stiffness,
          .friction = {.mu_static = mu_static, .mu_dynamic = friction},
          .stick_depth = {0.001}};
}

/// Rings round the pivot whose samples slip steadily: anchors trail at right angles to the lag (case F01).
void add_rings(PlanarSlide& s, double torque) {
  const double normal_force = torque / (2 * friction * radius) / 8, leash = friction * normal_force / stiffness;
  const double sense = s.spin < 0 ? -1 : 1;
  for (int i = 0; i < 8; ++i) {
    const double at = 2 * std::numbers::pi * i / 8;
    // The object sees the hand turn the other way; steady pursuit leans outwards by asin(ρ/a).
    const double direction = at - sense * (std::numbers::pi / 2 - std::asin(leash / radius));
    s.slipping.push_back(
        {radius * Vector2d{std::cos(at), std::sin(at)}, 2 * friction * normal_force, leash, direction});
  }
}

/// The pivot's springs are stiff, w h = 0.9: to the step they are a constraint, and the swing, which gravity drives
/// from outside the solve, advances as in semi-implicit Euler: as leapfrog would from a spin that is half a sub-step's
/// change ahead at the start. What that makes of the turn, ½ h α0 ∂angle/∂spin0, is ½ h (spin(t) − spin0 C(t)) with
/// |C| <= 1 (both solve the linearised equation; R03). Leapfrog's own error is (ω h)² (1/8 + ω t/24) of the swing;
/// twice that at these amplitudes.
Limit swing_limit(double t, double spin, double first_spin) {
  const double second_order = 2 * start * std::pow(frequency / 360, 2) * (0.125 + frequency * t / 24);
  return {.value = second_order,
          .per_step = 0.51 * (std::abs(spin) + std::abs(first_spin)),
          .reason =
              "half a sub-step times the spin now and at the start (R03), + twice leapfrog's (w h)^2 (1/8 + w t/24) of "
              "the swing at the "
              "sub-step 1/360 s: to the step, the stiff pivot is a constraint"};
}

const std::string source = "L2: pendulum on a spring pivot by GSL; 1e-11 against 1e-13 a step agrees to 1e-12";

Claim angle_at(const PlanarSlide& s, int frame, bool converges) {
  const double t = frame / 90.0;
  const PlanarState now = planar_state(s, t);
  return of_pedigree(Pedigree::converged,
                     claim(fmt::format("turn by t = {}/90 s", frame), now.angle - s.angle, source, rotation_at(t, axis),
                           absolute_controlled_limit(), swing_limit(t, now.spin, s.spin), /*converges=*/converges));
}

Run free_run() {
  const PlanarSlide s = pendulum(start, 0, 0);
  const double end = 56.0 / 90;  // nearly a period of 0.6231 s
  Run run{.name = "point pinch swings",
          .problem = [=] { return planar_scene("F03 point pinch", s, layout(friction), end); }};
  run.claims = {angle_at(s, 9, true), angle_at(s, 28, false), angle_at(s, 56, false)};
  run.curve = Curve{"turn [rad]", {.kind = Measure::Kind::rotation, .axis = axis}, [s](double t) {
                      return planar_state(s, t).angle - s.angle;
                    }};
  return run;
}

Run braked_run() {
  constexpr double torque = 0.005;
  PlanarSlide s = pendulum(start, -1, torque);
  add_rings(s, torque);
  const PlanarState stop = first_restick(s, 0.6);
  const double end = 32.0 / 90;
  Run run{.name = "friction torque brakes",
          .problem = [=] { return planar_scene("F03 ring pinch", s, layout(friction), end); }};
  Limit turned = swing_limit(stop.t, 0, 0);
  turned.value += 0.5 * (mass * gravity * arm + torque) / pivot_inertia / (360 * 360);
  turned.reason += "; + the turn in a sub-step at the most torque";
  run.claims = {
      angle_at(s, 9, true), angle_at(s, 22, false),
      of_pedigree(Pedigree::converged, claim("end of the first swing", stop.t, source, time_of(EventKind::restick),
                                             absolute_controlled_limit(),
                                             event_limit(2, "the spin is off by up to a sub-step of acceleration"))),
      of_pedigree(Pedigree::converged,
                  claim("turn in the first swing", stop.angle - s.angle, source,
                        rotation_when(EventKind::restick, axis), absolute_controlled_limit(), turned))};
  return run;
}

/// At rest at `start`: the pivot carries the weight and the rings, twisted against it, the torque. `share`: of m g l
/// sin th to the torque of breakaway.
Run hold_run(double share) {
  // 16 springs on the rings: torque 16 k a² sin(twist), lag 2 a sin(twist/2).
  const double sine = mass * gravity * arm * std::sin(start) / (16 * stiffness * radius * radius);
  const double twist = std::asin(sine), limit_twist = std::asin(sine / share);
  PlanarSlide s = pendulum(start, 0, 0);
  s.center = Vector2d{-mass * gravity / (2 * stiffness), 0} + arm * hanging(start);
  PlanarLayout of = layout(1.2 * friction);
  for (int i = 0; i < 8; ++i) {
    const double at = 2 * std::numbers::pi * i / 8;
    const Vector2d place{std::cos(at), std::sin(at)}, anchor{std::cos(at - twist), std::sin(at - twist)};
    const Vector2d from_center = radius * anchor - s.center;
    s.sticking.push_back({.p = radius * place,
                          .anchor_B = {-from_center.dot(hanging(start)), -from_center.dot(swinging(start))},
                          .stiffness = 2 * stiffness});
    of.stick_depth.push_back(2 * radius * std::sin(limit_twist / 2) / of.friction.mu_static);
  }
  return near_threshold(
      share, [=] { return planar_scene("F03 near the threshold", s, of, 0.3); },
      yes_or_no("holds", share < 1, "L2: m g l sin th0 <= 16 k a^2 sin tw, 2 a sin(tw/2) = mu_s N/k; L1: 2 mu_s N a",
                {.kind = Measure::Kind::held, .axis = down, .level = 0.002}));
}

}  // namespace

Case pivot_case() {
  return {.id = "F03",
          .title = "Pendulum held off-centre between two fingertips",
          .truth_level = "L2",
          .statement =
              "A body of 0.1 kg and 4e-4 kg m^2 about its pivot, 50 mm above its centre of mass, is let go at 1.2 rad "
              "between "
              "two points, or two points with friction rings (5 mN m) round them.",
          .formula =
              "no friction: period 4 K(sin(th0/2)) sqrt(I/(m g l)); with it m g l (cos th1 - cos th0) = T (th0 - th1); "
              "held iff m g l |sin th0| <= T",
          .note =
              "k = 5000 N/m a sample: the pivot yields, by 0.1 mm, and truth is the equation of motion of body, pivot "
              "springs and leashes, integrated by a program of its own; the turn by 0.3 s is 0.4 mrad off "
              "the rigid closed form, a difference that falls as 1/k. mu = 0.5; the braked run starts with -1 rad/s.",
          .runs = {free_run(), braked_run(), hold_run(0.98), hold_run(1.02)}};
}

}  // namespace handhold::catalogue
