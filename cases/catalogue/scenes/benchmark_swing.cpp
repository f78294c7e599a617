// SPDX-License-Identifier: GPL-3.0-or-later
// S5: a cube that swings between two opposite fingertips.

#include <cmath>
#include <numbers>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/scenes/benchmark_families.hpp"
#include "cases/closed_form/off_centre_pinch.hpp"

namespace handhold::catalogue {
namespace {

constexpr double half_edge = 0.03;              // [m]
constexpr closed_form::OffCentrePinch rigid{};  // 0.2 kg, 2 cm off the centre
constexpr double mu = 0.8;
constexpr double friction_torque = 0.03;   // of both fingertips, S5b [N m]
constexpr double friction_radius = 0.001;  // of the ring that gives it, S5b [m]
const Eigen::Vector3d axis = Eigen::Vector3d::UnitX();

// Tangential, of both fingertips [N/m]: the pivot gives way by at most 3 m g / K = 15 µm, so that the energy (m g)² / K
// that its springs take is 3e-4 of m g l, and with it the change of the period.
constexpr double pivot_stiffness = 4e5;
constexpr double pivot_damping = 250;  // half critical: √(K m) = 283 N s/m

/// Every anchor starts where steady sliding has it: ahead of its sample, at right angles to the lag (case F01).
std::vector<SampleStart> sliding_already(const std::vector<Eigen::Vector3d>& p_W, const Eigen::Vector3d& center,
                                         double lag) {
  std::vector<SampleStart> start;
  for (const Eigen::Vector3d& p : p_W) {
    const Eigen::Vector3d radial = p - center;
    const double a = radial.norm(), b = std::sqrt(a * a - lag * lag);
    const Eigen::Vector3d outward = radial / a, along = axis.cross(outward);
    const Eigen::Vector3d anchor = b * (b / a * outward + lag / a * along);
    start.push_back({.lag_W = radial - anchor, .slipping = true});
  }
  return start;
}

}  // namespace

BenchmarkScene swing_benchmark(bool with_friction) {
  closed_form::OffCentrePinch truth = rigid;
  const int samples = with_friction ? 8 : 1;  // one sample a fingertip has no torsional friction
  // S5a: 60 N, far above the 3.6 N of the swing. S5b: what makes the torque 2 μ N r; a ring's is that of a rigid one of
  // radius √(a² − lag²), lag = μ × depth (closed_form/spin_down.hpp). The load that the ring carries besides, 1 N of
  // 15, takes (1/15)² / 4 = 0.1 % of its torque, a tenth of a degree of the angle.
  const double normal_force = with_friction ? friction_torque / (2 * mu * friction_radius) : 60;
  const double depth = normal_force / (pivot_stiffness / 2), lag = mu * depth;
  const double radius = with_friction ? std::hypot(friction_radius, lag) : 0;

  BenchmarkScene made;
  made.title = with_friction ? "cube swings between fingertips, torsional friction" : "cube swings between fingertips";
  made.scene.duration = 4.5;
  made.scene.contact = {.stiffness = pivot_stiffness / 2 / samples, .damping = pivot_damping / 2 / samples};
  Body cube = benchmark_block("cube", Eigen::Vector3d::Constant(half_edge), 0, truth.mass, {mu, mu});
  cube.X_WO.p.z() = 0.5;
  const Eigen::Vector3d pivot_O{0, truth.arm, 0}, pivot_W = cube.X_WO * pivot_O;

  std::vector<MovingPatch> patches;
  for (const int side : {-1, 1}) {
    const Eigen::Vector3d center = pivot_W + side * (half_edge - depth) * axis;
    const auto points = ring(center, axis, Eigen::Vector3d::UnitY(), radius, samples);
    const auto start = with_friction ? sliding_already(points, center, lag) : std::vector<SampleStart>{};
    const Path still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
    patches.push_back({side < 0 ? 2 : 5, points, start, still});
  }
  made.scene.bodies = {std::move(cube)};
  made.scene.hands = {hand_of(patches, made.scene.duration)};
  made.boxes = {{{Eigen::Vector3d::Constant(half_edge), {}}}};

  SwingPlan plan{.axis_W = axis, .pivot_O = pivot_O, .pivot_W = pivot_W};
  truth.torque = with_friction ? friction_torque : 0;
  if (with_friction) plan.turning_angle = closed_form::turning_angle(truth, std::numbers::pi / 2);
  if (!with_friction) plan.half_period = closed_form::half_period(truth, std::numbers::pi / 2);
  made.plan = plan;
  return made;
}

}  // namespace handhold::catalogue
