// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/projectile.hpp"

namespace handhold::catalogue {
namespace {

const Eigen::Vector3d right = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitZ();

Scene scene(const closed_form::Projectile& p, double duration) {
  Scene scene;
  scene.name = "A01 projectile";
  scene.duration = duration;
  Body body = block({edge, edge, edge}, voxel, 0.2, {});
  body.V_WO.v = p.speed * right + p.climb * up;
  scene.bodies = {body};
  return scene;
}

}  // namespace

Case projectile_case() {
  const closed_form::Projectile p{.speed = 0.6, .climb = 1.1, .gravity = 9.81};
  const double end = 0.5;
  Run run{.name = "flies", .problem = [=] { return scene(p, end); }};
  const Limit rounding{
      .value = 1e-12, .relative = true, .reason = "exact for a constant force (R03): rounding of 180 sub-steps"};
  run.claims = {
      claim("distance at t = 0.5 s", distance(p, end), "x = vx t", displacement_at(end, right), controlled_limit(),
            rounding),
      claim("speed at t = 0.5 s", climb_at(p, end), "v = vz - g t", speed_at(end, up), controlled_limit(), rounding),
      claim("height at t = 0.1 s", height(p, 0.1), "z = vz t - g t^2 / 2", displacement_at(0.1, up), controlled_limit(),
            euler_bias_limit(p.gravity * 0.1)),
      claim("height at t = 0.5 s", height(p, end), "z = vz t - g t^2 / 2", displacement_at(end, up), controlled_limit(),
            euler_bias_limit(p.gravity * end), /*converges=*/true)};
  run.curve =
      Curve{"height [m]", {.kind = Measure::Kind::displacement, .axis = up}, [p](double t) { return height(p, t); }};
  return {.id = "A01",
          .title = "Projectile",
          .truth_level = "L1",
          .statement = "A cube is thrown with 0.6 m/s along and 1.1 m/s up; no hand.",
          .formula = "x = vx t, z = vz t - g t^2 / 2",
          .note = "No contact: any error here is the integrator's.",
          .runs = {run}};
}

}  // namespace handhold::catalogue
