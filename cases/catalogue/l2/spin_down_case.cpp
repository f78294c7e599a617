// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/spin_down.hpp"

namespace handhold::catalogue {
namespace {

constexpr double stiffness = 1000;  // per sample
constexpr int samples = 8;
const Eigen::Vector3d axis = Eigen::Vector3d::UnitY();
constexpr auto ring_patch = closed_form::PatchShape::ring;

closed_form::SpinDown spin_down() {
  return {.inertia = 1e-4, .normal_force = 2, .mu = 0.5, .radius = 0.004, .spin = 20, .stiffness = samples * stiffness};
}

/// Every anchor starts on its pursuit curve: ahead of its sample (in the sense of the spin), at right angles to the
/// lag.
std::vector<SampleStart> pursuit(const std::vector<Eigen::Vector3d>& p_W, double lag) {
  std::vector<SampleStart> start;
  for (const Eigen::Vector3d& p : p_W) {
    const Eigen::Vector3d radial = p - p.dot(axis) * axis;
    const double a = radial.norm();
    const double b = std::sqrt(a * a - lag * lag);  // radius of the anchor's circle
    const Eigen::Vector3d outward = radial / a;
    const Eigen::Vector3d along = axis.cross(outward);  // the way the object's surface moves
    const Eigen::Vector3d anchor = b * (b / a * outward + lag / a * along);
    start.push_back({.lag_W = radial - anchor, .slipping = true});
  }
  return start;
}

/// Euler's step takes friction where it starts: half a turn of the step behind its middle. Where it leans by ρ/a
/// against the circle, the torque is off by sin(ρ/a) ω h/2 of itself, and so, at most, is the change of the angle.
Limit turned_limit(double spin_lost, double angle_lost) {
  const closed_form::SpinDown s = spin_down();
  Limit limit = euler_bias_limit(spin_lost);
  limit.per_step += 0.5 * s.spin * lag(s) / s.radius * angle_lost;
  limit.reason += "; friction where the step starts leans by w h/2, which changes a torque that leans by rho/a";
  return limit;
}

Scene scene(double duration) {
  const closed_form::SpinDown s = spin_down();
  Scene scene;
  scene.name = "F01 spin-down";
  scene.duration = duration;
  scene.gravity.setZero();
  scene.contact = {.stiffness = stiffness, .damping = 0};
  Body body = block({edge, edge, edge}, voxel, 0.2, {.mu_static = s.mu, .mu_dynamic = s.mu});
  body.inertia.about_center = s.inertia * Eigen::Matrix3d::Identity();
  body.V_WO.w = s.spin * axis;
  scene.bodies = {body};
  const Path still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  const auto no_grip = [](double) { return 0.0; };
  auto patches = pinch_patches(edge / 2, s.normal_force / s.stiffness, {}, no_grip, still);
  for (MovingPatch& patch : patches) patch.start = pursuit(patch.p_W, lag(s));
  scene.hands = {hand_of(patches, duration)};
  return scene;
}

}  // namespace

Case spin_down_case() {
  const closed_form::SpinDown s = spin_down();
  const double duration = 24.0 / 90;
  const double mid = 18.0 / 90;  // still spinning, on a frame
  const double deceleration = torque(s, ring_patch) / s.inertia;
  Run run{.name = "spins down", .problem = [=] { return scene(duration); }};
  run.claims = {
      claim("stop time", stop_time(s, ring_patch), "L2: I w0 / T, T = 2 mu N sqrt(a^2 - rho^2), rho = mu N / K",
            time_of(EventKind::restick), controlled_limit(), event_limit()),
      claim("angle at the stop", stop_angle(s, ring_patch), "L2: I w0^2 / (2 T)",
            rotation_when(EventKind::restick, axis), controlled_limit(),
            turned_limit(s.spin, stop_angle(s, ring_patch))),
      claim("angle at t = 0.2 s", angle(s, ring_patch, mid), "L2: w0 t - T t^2 / (2 I)", rotation_at(mid, axis),
            controlled_limit(), turned_limit(deceleration * mid, s.spin * mid - angle(s, ring_patch, mid)),
            /*converges=*/true)};
  run.curve = Curve{"angle [rad]", {.kind = Measure::Kind::rotation, .axis = axis}, [s](double t) {
                      return t < stop_time(s, ring_patch) ? angle(s, ring_patch, t) : std::nan("");
                    }};
  return {.id = "F01",
          .title = "Spin-down between two fingertips: torsional friction of a patch",
          .truth_level = "L2",
          .statement =
              "An object of 1e-4 kg m^2 spins at 20 rad/s about the axis of a pinch; each patch of 4 mm radius presses "
              "with 2 N; mu = 0.5; no gravity.",
          .formula =
              "T = 2 mu N a (ring of n >= 2 samples), 2/3 of it (disc), 3 pi/16 (Hertz); t = I w0 / T, angle = I w0^2 "
              "/ (2 T)",
          .note =
              "Judged against the L2 closed form of the ring at k = 1000 N/m a sample: anchors trail on a pursuit "
              "curve of radius "
              "sqrt(a^2 - rho^2), rho = 0.125 mm, 0.05 % less torque than L1 (0.25 s, 2.5 rad).",
          .runs = {run}};
}

}  // namespace handhold::catalogue
