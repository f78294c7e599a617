// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/printed_problems.hpp"
#include "cases/catalogue/l3/families.hpp"

// Eight samples on a ring whose phalanx turns over a fixed face.

namespace handhold::catalogue {
namespace {

using closed_form::PrintedFace;

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
constexpr double twist = 0.4;  // [rad]

double twisted(double t) { return t > 0 ? twist : 0; }

Measure torque_at(double t) { return {.kind = Measure::Kind::torque, .axis = up, .at = t}; }

Run collapse_run(Ground ground) {
  const PrintedFace face;
  const double a = 0.005;
  const auto collapse = patch_collapse(face, a);
  const auto at = [&](int k) { return k * face.frame; };
  const int frames = collapse.frames + 3;
  Run run{.name = "one centroid", .problem = [=] {
            PrintedProblem p = ring_on_a_face(ground, face, a, twisted, frames);
            p.law.point = printed::Point::centroid;
            return p;
          }};
  const auto radius = [&](int k) {  // the first sample's anchor lies on +x, the centroid at 0
    return Measure{.kind = Measure::Kind::lag, .axis = -Eigen::Vector3d::UnitX(), .at = at(k), .sample = 0};
  };
  Limit torque{.value = rounding_limit(a, 1, 8 * face.gamma * a, "").value,
               .reason = "eight forces of gamma a, each through the axis but for four roundings of a"};
  run.claims = {printed_claim("torque about the normal, slipping", 0, "all forces go through the centroid",
                              torque_at(at(1)), torque),
                printed_claim("torque about the normal, sticking", 0, "all forces go through the centroid",
                              torque_at(at(frames)), torque),
                printed_claim("radius after one frame", a * contraction(face), "r -> q r a frame while r > mu_s d",
                              radius(1), ray_limit(ground, face, a, a)),
                printed_claim("radius in the end", collapse.radius, "a q^n, the first not above mu_s d", radius(frames),
                              ray_limit(ground, face, collapse.radius, collapse.radius)),
                printed_count("samples that slip in the last frame above", 8, "r > mu_s d",
                              count_at(at(collapse.frames - 1), Mode::slip)),
                printed_count("samples that slip in the frame after", 0, "r <= mu_s d",
                              count_at(at(collapse.frames), Mode::slip))};
  return run;
}

Run own_points_run(Ground ground) {
  const PrintedFace face{.friction = {1, 1}};  // at mu_s = 0.5 this twist would slip: its lag is 2 mm
  const double a = 0.005;
  Run run{.name = "points of their own", .problem = [=] { return ring_on_a_face(ground, face, a, twisted, 1); }};
  run.claims = {printed_claim("torque of a twist of 0.4 rad", closed_form::stick_torque(face.gamma, 8, a, twist),
                              "8 gamma a^2 sin(phi)", torque_at(face.frame),
                              rounding_limit(a, a, 4, "arm, force and the sum of eight"))};
  return run;
}

Run spin_run(Ground ground) {
  const PrintedFace face;
  const double a = 0.004, spin = 60;
  const int frames = 100;  // q^100 = 2e-15
  const double end = frames * face.frame;
  Run run{.name = "60 rad/s", .problem = [=] {
            return ring_on_a_face(
                ground, face, a, [=](double t) { return spin * t; }, frames);
          }};
  Limit limit = ray_limit(ground, face, a, spin_lag(face, a, spin));
  limit.value += 4 * std::pow(contraction(face), frames);  // what is left of the start
  run.claims = {
      printed_claim("steady torque", spin_torque(face, 8, a, spin),
                    "8 mu_d gamma a^2 (1 - q) sin(w dt)/|e^{i w dt} - q|^2", torque_at(end), limit),
      printed_count("slipping samples", 8, "a |e^{i w dt} - 1|/|e^{i w dt} - q| > mu_s d", count_at(end, Mode::slip))};
  return run;
}

}  // namespace

Case printed_patch_case() {
  Case c = printed_case("L3-07", "Samples on one centroid carry no torque, and their ring shrinks by itself");
  c.statement = "A ring of 8 samples, radius 5 mm, pressed 2.5 mm into a fixed face and then twisted by 0.4 rad.";
  c.formula = "as printed: torque 0, r -> q r until r <= mu_s d; own points: 8 gamma a^2 sin(phi)";
  for (const auto& make : {collapse_run, own_points_run})
    for (Run& run : on_both(make)) c.runs.push_back(std::move(run));
  return c;
}

Case printed_spin_case() {
  Case c = printed_case("L3-14", "Spinning is viscous, too");
  c.statement = "A ring of 8 samples, radius 4 mm, with points of their own, spins on a fixed face with 60 rad/s.";
  c.formula = "T = 8 mu_d gamma a^2 (1 - q) sin(w dt)/|e^{i w dt} - q|^2; Coulomb: mu_d N a";
  c.runs = on_both(spin_run);
  return c;
}

}  // namespace handhold::catalogue
