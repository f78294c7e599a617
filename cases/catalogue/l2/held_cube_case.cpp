// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/held_cube.hpp"
#include "cases/closed_form/pendulum.hpp"

namespace handhold::catalogue {
namespace {

const Eigen::Vector3d across = Eigen::Vector3d::UnitX(), normal = Eigen::Vector3d::UnitY(),
                      down = -Eigen::Vector3d::UnitZ();

closed_form::HeldCube cube() { return {.edge = edge}; }

Scene scene(const Twist& start, double damping, double gravity, double duration) {
  const closed_form::HeldCube c = cube();
  Scene scene;
  scene.name = "G10 held cube";
  scene.duration = duration;
  scene.gravity = gravity * down;
  scene.contact = {.stiffness = c.stiffness / 8, .damping = damping};
  Body body = block({c.edge, c.edge, c.edge}, voxel, c.mass, {.mu_static = 1, .mu_dynamic = 1});
  body.V_WO = start;
  scene.bodies = {body};
  const Path still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  const auto no_grip = [](double) { return 0.0; };
  scene.hands = {hand_of(pinch_patches(c.edge / 2, c.depth, {}, no_grip, still), duration)};
  return scene;
}

double frame(int n) { return n / 90.0; }

/// Set off from the middle with speed v along `axis`: x = v/w sin w t.
Run translation_run(const std::string& name, const Eigen::Vector3d& axis, double v) {
  const double w = translation_frequency(cube()), end = frame(6);
  Run run{.name = name, .problem = [=] { return scene({.v = v * axis}, 0, 0, end); }};
  for (const int n : {2, 6})
    run.claims.push_back(claim(fmt::format("place at t = {}/90 s", n), v / w * std::sin(w * frame(n)),
                               "L2: v/w sin w t, w^2 = 2 K/m", displacement_at(frame(n), axis),
                               absolute_controlled_limit(), implicit_ring_limit(v / w, w, frame(n)),
                               /*converges=*/n == 2));
  run.curve = Curve{"place [m]", {.kind = Measure::Kind::displacement, .axis = axis}, [=](double t) {
                      return v / w * std::sin(w * t);
                    }};
  return run;
}

/// Set off with `spin` about `axis`: a pendulum of frequency w.
Run rotation_run(const std::string& name, const Eigen::Vector3d& axis, double w, double spin, int first, int last,
                 const std::string& formula) {
  const double end = frame(last);
  Run run{.name = name, .problem = [=] { return scene({.w = spin * axis}, 0, 0, end); }};
  for (const int n : {first, last})
    run.claims.push_back(
        claim(fmt::format("angle at t = {}/90 s", n), closed_form::swing_from_bottom(w, spin, frame(n)),
              "L2: sin(th/2) = kappa sn(W t, kappa), kappa = w0/(2 W), " + formula, rotation_at(frame(n), axis),
              absolute_controlled_limit(), implicit_ring_limit(spin / w, w, frame(n)), /*converges=*/n == first));
  run.curve = Curve{"angle [rad]", {.kind = Measure::Kind::rotation, .axis = axis}, [=](double t) {
                      return closed_form::swing_from_bottom(w, spin, t);
                    }};
  return run;
}

Run sag_run() {
  const double end = 0.3;  // the transient has faded to exp(-80 t), 4e-11
  Run run{.name = "sags", .problem = [=] { return scene({}, 2, cube().gravity, end); }};
  run.claims = {claim("sag", sag(cube()), "L2: m g/(2 K)", displacement_at(end, down), absolute_controlled_limit(),
                      {.value = 1e-9,
                       .relative = true,
                       .reason = "rest does not depend on the step; 4e-11 of the settling is left, in the "
                                 "implicit step up to ten times that"})};
  return run;
}

}  // namespace

Case held_cube_case() {
  const closed_form::HeldCube c = cube();
  return {.id = "G10",
          .title = "Compliant pinch: modes and sag of a held cube",
          .truth_level = "L2",
          .statement = "A 0.2 kg cube of 62.5 mm between two rings of 4 mm radius that press with 2 N; mu = 1.",
          .formula =
              "w_n^2 = w_t^2 = 2 K/m, w_roll^2 = (2 K s^2/4 + K a^2 - N s)/I, w_spin^2 = 2 K a^2/I, I = m s^2/6; sag "
              "m g/(2 K)",
          .note =
              "k = 100 N/m a sample, undamped (the sag: c = 2 N s/m). Sticking springs of zero natural length make "
              "every turn an exact pendulum, so no amplitude need be small.",
          .runs = {translation_run("along the normal", normal, 0.05), translation_run("across it", across, 0.05),
                   rotation_run("rolls about a tangent", across, roll_frequency(c), 1, 2, 5,
                                "W^2 = (2 K s^2/4 + K a^2 - N s)/I"),
                   rotation_run("spins about the normal", normal, spin_frequency(c), 1, 9, 27, "W^2 = 2 K a^2/I"),
                   sag_run()}};
}

}  // namespace handhold::catalogue
