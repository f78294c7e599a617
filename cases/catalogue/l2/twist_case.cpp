// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/prescribed_hand.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/twisted_ring.hpp"

namespace handhold::catalogue {
namespace {

constexpr double spin = 0.5;  // of the hand [rad/s]
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

Scene scene(const closed_form::TwistedRing& r, double duration) {
  Scene scene;
  scene.name = fmt::format("G08 twist, offset {:.6g} m", r.offset);
  scene.duration = duration;
  scene.contact = {.stiffness = r.stiffness, .damping = 0};
  Body body = block({edge, edge, edge}, voxel, 0.2, r.friction);
  body.mobility = Mobility::fixed;
  body.X_WO.p.z() = edge / 2 - r.normal_force / (r.samples * r.stiffness);
  scene.bodies = {body};
  const Eigen::Vector3d center{r.offset, 0, 0};
  PrescribedPatch patch{.phalanx = palm};
  patch.p_P = ring(-center, up, Eigen::Vector3d::UnitX(), r.radius, r.samples);
  patch.start.resize(patch.p_P.size());
  patch.pose = [center](double t) { return Pose{Eigen::Quaterniond(Eigen::AngleAxisd(spin * t, up)), center}; };
  scene.hands = {prescribed_hand({patch}, duration, 2000)};
  return scene;
}

/// A slipping sample's pull has direction ψ; the step's own curve of pursuit is off by up to half the hand's turn in a
/// step (its fixed point is, and it starts exact), which changes F D cos ψ by F D sin ψ <= F ρ times that.
Limit pursuit_limit(const closed_form::TwistedRing& r, double angle) {
  const double friction = r.friction.mu_dynamic * r.normal_force / r.samples;
  return {.value = 1e-12 * torque(r, angle),
          .per_step = slipping(r, angle) * friction * (friction / r.stiffness) * 0.5 * spin * 1.02,
          .reason =
              "exact in stick; a slipping sample pulls up to half the hand's turn of a step off its direction: "
              "times F rho of each, + 2 %"};
}

Claim torque_at(const closed_form::TwistedRing& r, int frame, bool converges) {
  const double t = frame / 90.0;
  return claim(fmt::format("torque at {:.4g} rad", spin * t), torque(r, spin * t),
               "L2: sum of k D^2 sin th (stick) and F D cos psi(th) (slip, curve of pursuit)",
               {.kind = Measure::Kind::torque, .axis = up, .at = t, .point = {r.offset, 0, 0}}, controlled_limit(),
               pursuit_limit(r, spin * t), /*converges=*/converges);
}

Claim first_slip(const closed_form::TwistedRing& r) {
  return claim("first slip", first_slip_angle(r) / spin, "L2: 2 asin(mu N/(2 n k max D)) of turn",
               time_of(EventKind::breakaway), controlled_limit(), event_limit());
}

Run offset_run() {
  const closed_form::TwistedRing r;
  const double end = 63.0 / 90;
  Run run{.name = "about a centre 3 mm off", .problem = [=] { return scene(r, end); }};
  run.claims = {torque_at(r, 27, false), first_slip(r), torque_at(r, 45, true), torque_at(r, 63, true)};
  run.claims.push_back(claim(
      "samples that slip by 0.35 rad", double(slipping(r, spin * end)), "L2: those with 2 D sin(th/2) > mu N/(n k)",
      {.kind = Measure::Kind::event_count, .event = EventKind::breakaway}, exact_limit(), exact_limit()));
  return run;
}

Run concentric_run() {
  const closed_form::TwistedRing r{.offset = 0};
  const double end = 72.0 / 90;
  Run run{.name = "about its own centre", .problem = [=] { return scene(r, end); }};
  run.claims = {torque_at(r, 45, false), first_slip(r), torque_at(r, 72, true)};
  return run;
}

}  // namespace

Case twist_case() {
  return {
      .id = "G08",
      .title = "Ring of 8 samples twisted about an off-set point: progressive slip",
      .truth_level = "L2",
      .statement =
          "A ring of 4 mm radius presses with 2 N on an object that is held fast and turns about a point 3 mm from its "
          "centre; mu = 0.5.",
      .formula =
          "small angles: T = sum min(k th D_i, mu N/8) D_i, first slip at mu N/(8 k max D); exact: k D^2 sin th, "
          "slip at 2 asin(mu N/(16 k D)), then a curve of pursuit psi' = 1 - (D/rho) sin psi, torque F D cos psi",
      .note =
          "k = 100 N/m a sample, undamped, 0.5 rad/s. At 0.35 rad the small-angle torque of the catalogue, 4.3417 "
          "mN m, is 1.3 % above the exact one.",
      .runs = {offset_run(), concentric_run()}};
}

}  // namespace handhold::catalogue
