// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "cases/catalogue/builders/printed_problems.hpp"
#include "cases/catalogue/l3/families.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"

// What is not flat: slopes of voxels, and a ball.

namespace handhold::catalogue {
namespace {

using closed_form::PrintedFace;
using Eigen::Vector3d;

// --- L3-11 -----------------------------------------------------------------------------------------------------------

Vector3d normal_of(double slope) { return {std::sin(slope), 0, std::cos(slope)}; }

/// A sample at a place of the surface, and from the next frame on pressed straight in along `n`.
PrintedProblem pressed(const printed::Shape& shape, const Vector3d& place, const Vector3d& n, double depth) {
  return {.shape = shape,
          .mobility = Mobility::fixed,
          .phalanges = {{.p_P = {Vector3d::Zero()},
                         .pose = [=](double t) { return Pose{.p = t > 0 ? Vector3d(place - depth * n) : place}; }}},
          .frames = 1};
}

/// What the claims say of a press of eq. 1's γ d into a slope; `places` rounds.
std::vector<Claim> press_claims(double slope, double places) {
  const PrintedFace face;
  const auto truth = tilted_press(face, slope);
  const Limit limit = rounding_limit(places, face.depth, 4, "the projections have as many");
  std::vector<Claim> claims{
      printed_count("sticks", truth.sticks, "tan(phi) <= mu_s", count_at(face.frame, Mode::stick)),
      printed_claim("force straight in", truth.normal, "gamma d (cos^2 + mu_d sin^2), or gamma d",
                    force_at(face.frame, -normal_of(slope)), limit)};
  if (!truth.sticks)
    claims.push_back(printed_claim("force across", truth.tangent, "gamma d (1 - mu_d) sin cos",
                                   force_at(face.frame, {std::cos(slope), 0, -std::sin(slope)}), limit));
  return claims;
}

Run plane_run(double slope) {
  Run run{.name = fmt::format("normal off by {:.2g} rad", slope), .problem = [=] {
            return pressed(printed::Plane{}, Vector3d::Zero(), normal_of(slope), PrintedFace{}.depth);
          }};
  run.claims = press_claims(slope, PrintedFace{}.depth);
  return run;
}

/// A block whose upper face is inclined.
std::shared_ptr<const VoxelField> inclined(double slope) {
  Mesh mesh = make_box({0.06, 0.03, 0.03});
  const Eigen::Matrix3d R = Eigen::AngleAxisd(slope, Vector3d::UnitY()).toRotationMatrix();
  for (Vector3d& v : mesh.vertices) v = R * v;
  return voxelize(mesh, {.voxel_size = 0.001});
}

/// Centre of the upper face of the highest voxel above the middle of the slope.
Vector3d top_face(const VoxelField& field, double slope) {
  const Grid& grid = field.grid();
  const Eigen::Vector3i at = ((0.015 * normal_of(slope) - grid.origin) / grid.spacing).array().round().cast<int>();
  int k = grid.size.z() - 1;
  while (!field.occupied(at.x(), at.y(), k)) --k;
  return grid.node(at.x(), at.y(), k) + grid.spacing / 2 * Vector3d::UnitZ();
}

Run voxel_run(double slope) {
  Run run{.name = fmt::format("voxels of a slope of {:.2g} rad", slope), .problem = [=] {
            const auto field = inclined(slope);
            return pressed(printed::Voxels{field, printed::Normals::voxel}, top_face(*field, slope), normal_of(slope),
                           PrintedFace{}.depth);
          }};
  run.claims = press_claims(slope, 0.015);
  return run;
}

Run smooth_run(printed::Normals normals, const std::string& name) {
  const double slope = std::numbers::pi / 4;
  const PrintedFace face;
  Run run{.name = name, .problem = [=] {
            return pressed(printed::Voxels{inclined(slope), normals}, 0.015 * normal_of(slope), normal_of(slope),
                           face.depth);
          }};
  run.claims = {printed_count("sticks", 1, "the normal is the slope's", count_at(face.frame, Mode::stick)),
                printed_claim("force straight in", face.gamma * face.depth, "gamma d, all of it",
                              force_at(face.frame, -normal_of(slope)),
                              rounding_limit(0.03, face.depth, 4, "the projections have as many"))};
  return run;
}

// --- L3-13 -----------------------------------------------------------------------------------------------------------

constexpr double ball_radius = 0.03, first_angle = 0.1;

/// A point straight below the ball's top, its anchor at first_angle. Without friction every frame slips.
PrintedProblem on_a_ball(const printed::Shape& shape, int frames) {
  const Vector3d p(0, 0, ball_radius - PrintedFace{}.depth);
  const Vector3d anchor = ball_radius * Vector3d(std::sin(first_angle), 0, std::cos(first_angle));
  return {.shape = shape,
          .friction = {0, 0},
          .mobility = Mobility::fixed,
          .phalanges = {{.p_P = {Vector3d::Zero()},
                         .start = {{.lag_W = p - anchor, .slipping = true}},
                         .pose = [=](double) { return Pose{.p = p}; }}},
          .frames = frames};
}

double angle_after(int rays) {
  double angle = first_angle;
  const PrintedFace face;
  for (int k = 0; k < rays; ++k) angle = closed_form::ball_anchor(ball_radius, face.depth, face.offset, angle);
  return angle;
}

Claim anchor_claim(int rays, const Limit& limit) {
  return printed_claim(
      fmt::format("anchor beside the closest point after {} ray{}", rays, rays == 1 ? "" : "s"),
      ball_radius * std::sin(angle_after(rays)), "R sin(beta'), the first root of |o + t (p - o)| = R from C + eps n",
      {.kind = Measure::Kind::lag, .axis = -Vector3d::UnitX(), .at = rays * PrintedFace{}.frame}, limit);
}

Run ball_run() {
  Run run{.name = "exact ball", .problem = [] { return on_a_ball(printed::Ball{ball_radius}, 20); }};
  for (const int rays : {1, 5, 20}) {
    const PrintedFace face;
    run.claims.push_back(anchor_claim(
        rays, rounding_limit(ball_radius, 2 * face.offset, rays * face.offset / face.depth,
                             "|o|^2 - R^2 loses R/(2 eps), and moves the hit by eps/d of that, every ray")));
  }
  return run;
}

Run polyhedron_run() {
  Run run{.name = "polyhedron of facets of 1.1 mm", .problem = [] {
            return on_a_ball(printed::Voxels{voxelize(make_sphere(ball_radius, 5), {.voxel_size = 0.001})}, 1);
          }};
  const PrintedFace face;
  const double edge = 1.2 * ball_radius / 32, turn = edge / std::sqrt(3.0) / ball_radius;
  const double sag = ball_radius * (1 - std::cos(turn));
  run.claims = {anchor_claim(1, {.value = contraction(face) * face.offset * turn +
                                          first_angle * ball_radius * sag / (face.depth + face.offset),
                                 .reason = "facets turned by up to tau = asin(r/R) and R (1 - cos tau) below the ball: "
                                           "q eps tau + lag sag/(d + eps)"})};
  return run;
}

}  // namespace

Case printed_slope_case() {
  Case c = printed_case("L3-11", "On voxels a push straight into a slope slips");
  c.statement =
      "One sample is pressed 2.5 mm along the true normal of a slope; the law is given another normal, or not.";
  c.formula = "sticks iff tan(phi) <= mu_s; else gamma d (cos^2 + mu_d sin^2) in and gamma d (1 - mu_d) sin cos across";
  for (const double slope : {0.4, std::numbers::pi / 4, 1.2}) c.runs.push_back(plane_run(slope));
  for (const double slope : {0.4, std::numbers::pi / 4}) c.runs.push_back(voxel_run(slope));
  c.runs.push_back(smooth_run(printed::Normals::triangle, "triangles of that field"));
  c.runs.push_back(smooth_run(printed::Normals::smooth, "smooth normal of that field"));
  return c;
}

Case printed_ball_case() {
  Case c = printed_case("L3-13", "On a ball anchors contract towards the closest point");
  c.statement = "One sample 2.5 mm below the top of a ball of 30 mm without friction, its anchor 0.1 rad beside.";
  c.formula = "the ray's first root from C + eps n to p, repeated";
  c.runs = {ball_run(), polyhedron_run()};
  return c;
}

}  // namespace handhold::catalogue
