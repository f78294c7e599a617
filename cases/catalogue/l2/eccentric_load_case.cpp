// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/ring_limit.hpp"

namespace handhold::catalogue {
namespace {

constexpr double stiffness = 5000;  // per sample: lags of 0.05 mm, 1.3 % of the radius
constexpr double damping = 75;  // over critical in every mode (c >= 2 k/w, slowest w = 145 1/s): nothing overshoots
constexpr double gravity = 9.81;
const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();

/// A cube with its centre of mass at distance L from the axis, let go with slack springs.
Scene scene(const closed_form::EccentricLoad& l, double weight, double duration) {
  Scene scene;
  scene.name = fmt::format("F02 {:.6g} N at {:.6g} m", weight, l.arm);
  scene.duration = duration;
  scene.contact = {.stiffness = stiffness, .damping = damping};
  Body body = block({edge, edge, edge}, voxel, weight / gravity, {.mu_static = l.mu, .mu_dynamic = l.mu});
  body.inertia.center = {l.arm, 0, 0};
  body.inertia.about_center = 3e-5 * Eigen::Matrix3d::Identity();
  scene.bodies = {body};
  const Path still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  const auto no_grip = [](double) { return 0.0; };
  const double depth = l.normal_force / (8 * stiffness);
  scene.hands = {hand_of(pinch_patches(edge / 2, depth, {}, no_grip, still), duration)};
  return scene;
}

Run threshold_run(double arm, double share) {
  const closed_form::EccentricLoad l{.arm = arm};
  const double weight = share * limit_load(l).weight, end = 0.4;
  Run run = near_threshold(
      share, [=] { return scene(l, weight, end); },
      yes_or_no("holds", share < 1, "L1 = L2: W = 2 (mu N/8) min over c of sum |r_i - c|/(L + c), 8 samples",
                {.kind = Measure::Kind::held, .axis = down, .level = 0.1 * arm}));
  run.name = fmt::format("L = {} mm, {}", 1e3 * arm, run.name);
  return run;
}

}  // namespace

Case eccentric_load_case() {
  return {
      .id = "F02",
      .title = "Eccentric load on a pinch: exact limit load of two rings",
      .truth_level = "L1",
      .statement =
          "Two rings of 4 mm radius press with 4 N each and carry a weight 20 mm or 6 mm beside their axis; mu = 0.5.",
      .formula =
          "W = 2 mu N min over c >= 0 of <D(c)>/(L + c), D the distance from a centre of rotation c on the far "
          "side; ring: <D> = 2 (a + c) E(m)/pi, m = 4 a c/(a + c)^2",
      .note =
          "Judged against the limit load of the very 8 samples (0.77058 N, 2.01093 N; continuous ring 0.77059 N, "
          "2.02643 N). k = 5000 N/m, c = 75 N s/m, 2 x 8 samples: let go, the load comes on without overshoot. A "
          "slipping sample's force passes through its point on the hand, so the lag does not change the limit; "
          "held means that the load came down by less than 0.1 L.",
      .runs = {threshold_run(0.02, 0.98), threshold_run(0.02, 1.02), threshold_run(0.006, 0.98),
               threshold_run(0.006, 1.02)}};
}

}  // namespace handhold::catalogue
