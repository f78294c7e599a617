// SPDX-License-Identifier: GPL-3.0-or-later
// H07, H08: a finger slides round a cylinder and a sphere.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <Eigen/Geometry>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/prescribed_hand.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/bodies.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::RoundSlide;

constexpr int index_finger = 5;
constexpr double voxel_size = 1.0 / 1024, depth = 0.002, hand_rate = 1000;
const Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();

RoundSlide slide(double radius) { return {.radius = radius, .path_radius = radius - depth}; }

/// Starts in steady slip: the anchor lies where the foot of p − lag is, `trailing_angle` behind.
Scene scene(const std::string& name, const RoundSlide& r, const Mesh& mesh, double duration) {
  Scene scene;
  scene.name = name;
  scene.duration = duration;
  scene.gravity.setZero();
  scene.contact = {.stiffness = r.stiffness, .damping = 0};
  Body body;
  body.name = name;
  body.field = voxelize(mesh, {.voxel_size = voxel_size});
  body.inertia = {.mass = 1, .about_center = Eigen::Matrix3d::Identity()};
  body.friction = {r.mu, r.mu};
  body.mobility = Mobility::fixed;
  scene.bodies = {body};
  const double trail = trailing_angle(r);
  const Eigen::Vector3d sample(r.path_radius, 0, 0);
  const Eigen::Vector3d along(std::sin(trail), std::cos(trail), 0);
  PrescribedPatch finger{index_finger,
                         {sample},
                         {{.lag_W = r.mu * round_depth(r) * along, .slipping = true}},
                         [speed = r.speed](double t) {
                           return Pose{Eigen::Quaterniond(Eigen::AngleAxisd(speed * t, axis)), Eigen::Vector3d::Zero()};
                         }};
  scene.hands = {prescribed_hand({finger}, duration, hand_rate)};
  return scene;
}

/// What a surface that lies `inside` the round one (or half of that in and out) makes of the force: that much is
/// missing in the depth, and its slope over half a voxel or facet turns the normal, which counts 1/mu times in
/// friction.
double surface_share(const RoundSlide& r, double facet, double inside) {
  return inside / round_depth(r) + inside / (0.5 * std::max(voxel_size, facet)) / r.mu;
}

/// The middle of a triangle of that size lies this deep; the spline of the distances adds nothing (order 4).
double facet_error(const RoundSlide& r, double facet) { return facet * facet / (6 * r.radius); }

/// Distances interpolated linearly over a voxel are too large by h²/8 of their second derivatives, 1/R both ways.
double voxel_error(const RoundSlide& r) { return voxel_size * voxel_size / (4 * r.radius); }

/// An implicit step sees the surface where its anchor was: depth off by e w h + (R/2) (w h)² in a step at the step's
/// end.
double step_share(const RoundSlide& r) {
  constexpr double step = 1.0 / 360;
  return r.speed * r.mu + 0.5 * r.radius * r.speed * r.speed * step / round_depth(r);
}

Run run(const std::string& name, double radius, const std::function<Mesh()>& mesh, double facet) {
  const RoundSlide r = slide(radius);
  const double end = 36.0 / 90, mid = 18.0 / 90, torque = round_torque(r), loss = torque * r.speed * end;
  const double facets = facet_error(r, facet), share = surface_share(r, facet, facets);
  const double interpolated = surface_share(r, facet, facets + voxel_error(r)), step = 2 * step_share(r);
  const std::string of_facets = "facets lie f^2/(6 R) inside, and turn the normal: times 1/d + 2/(mu h)";
  const std::string surface = "facets and linear interpolation: (f^2/(6 R) + h^2/(4 R)) (1/d + 2/(mu h))";
  const std::string stepped = "; twice the step's own turn of the normal, mu w + R w^2 h/(2 d)";
  const Limit controlled{.value = share, .relative = true, .reason = of_facets};
  const Limit limit{.value = interpolated, .per_step = step, .relative = true, .reason = surface + stepped};
  Run run{.name = name, .problem = [=] { return scene(name, r, mesh(), end); }};
  run.claims = {claim("torque at t = 0.2 s", torque, "L2: K e R, e = rho sin(phi), sin(phi) + mu cos(phi) = mu R/rho",
                      {.kind = Measure::Kind::torque, .axis = axis, .at = mid}, controlled, limit),
                claim("torque at t = 0.4 s", torque, "L2: the same all the way round",
                      {.kind = Measure::Kind::torque, .axis = axis, .at = end}, controlled, limit),
                claim("energy lost", loss, "L2: torque times the angle gone round",
                      {.kind = Measure::Kind::dissipated, .at = end}, controlled, limit)};
  return run;
}

}  // namespace

Case round_cylinder_case() {
  constexpr double radius = 0.03;
  constexpr int segments = 512;
  return {.id = "H07",
          .title = "A finger slides round a cylinder",
          .truth_level = "L2",
          .statement = "A sample 2 mm inside a fixed cylinder of 30 mm radius goes round it with 3 rad/s; mu = 0.4.",
          .formula = "the anchor trails by phi, sin(phi) + mu cos(phi) = mu R/rho; torque K rho sin(phi) R, constant",
          .note = "K = 1000 N/m, undamped, in steady slip from the start. The truth is that of a round surface.",
          .runs = {run(
              "cylinder", radius, [] { return make_cylinder(radius, 0.06, segments); },
              2 * std::numbers::pi * radius / segments)}};
}

Case round_sphere_case() {
  constexpr double radius = 0.02;
  constexpr int subdivisions = 6;
  const double triangles = 20 * std::pow(4, subdivisions);
  return {
      .id = "H08",
      .title = "A finger slides round a sphere",
      .truth_level = "L2",
      .statement = "A sample 2 mm inside a fixed sphere of 20 mm radius goes round its equator with 3 rad/s; mu = 0.4.",
      .formula = "as H07",
      .note = "K = 1000 N/m, undamped, in steady slip from the start. The truth is that of a round surface.",
      .runs = {run(
          "sphere", radius, [] { return make_sphere(radius, subdivisions); },
          radius * std::sqrt(16 * std::numbers::pi / (std::sqrt(3) * triangles)))}};
}

}  // namespace handhold::catalogue
