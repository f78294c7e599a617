// SPDX-License-Identifier: GPL-3.0-or-later
// S3 and S4: blocks that slide, and blocks that stand.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "cases/catalogue/scenes/benchmark_families.hpp"
#include "cases/closed_form/incline.hpp"
#include "cases/closed_form/stopping.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::catalogue {
namespace {

constexpr double g = 9.81;
constexpr Friction friction{.mu_static = 0.5, .mu_dynamic = 0.5};
constexpr ContactParameters block_contact{.stiffness = 2e4, .damping = 20};
/// Hard, and damped so that it cannot overshoot: what a block at rest gains while its springs take up its weight along
/// the slope is C01's no more (closed_form::UnloadedStart). With block_contact the block of 30 degrees would be 2.2 %
/// ahead after a second, and that of 26 degrees would slip by 0.3 mm.
constexpr ContactParameters hard_contact{.stiffness = 2e5, .damping = 4e3};

/// The corners of a box, moved inwards by `inset` along x and y but not off its top and bottom. Two blocks of the same
/// size that lie on each other have corner on corner and edge on edge, where a surface has no normal: real ones are
/// rounded.
std::vector<Eigen::Vector3d> block_samples(const Eigen::Vector3d& half, double inset) {
  std::vector<Eigen::Vector3d> corners;
  for (const int z : {-1, 1})
    for (const int y : {-1, 1})
      for (const int x : {-1, 1}) corners.emplace_back(x * (half.x() - inset), y * (half.y() - inset), z * half.z());
  return corners;
}

/// A fixed plate whose upper face is the plane through the origin of its frame.
Body plate(const Eigen::Vector3d& half, double voxel_size) {
  Body body = benchmark_block("plate", half, voxel_size, 1, friction);
  body.mobility = Mobility::fixed;
  body.X_WO.p.z() = -half.z();
  return body;
}

void add(BenchmarkScene& made, Body body, const Eigen::Vector3d& half) {
  made.scene.bodies.push_back(std::move(body));
  made.boxes.push_back({{half, {}}});
}

/// A block on a plate that leans by `slope` about y (x then points down); its springs are in balance with its weight
/// across the plate, and have no part of it along the plate.
BenchmarkScene sliding(double slope, const Eigen::Vector3d& start, const Eigen::Vector3d& velocity) {
  BenchmarkScene made;
  const Eigen::Vector3d ground{2, 1, 0.25}, half{0.05, 0.05, 0.02};
  const Pose lean{Eigen::Quaterniond(Eigen::AngleAxisd(slope, Eigen::Vector3d::UnitY())), Eigen::Vector3d::Zero()};
  made.scene.body_contact = hard_contact;
  Body slope_body = plate(ground, 1.0 / 16);
  slope_body.X_WO = lean * slope_body.X_WO;
  Body block = benchmark_block("block", half, 0.001, 0.5, friction);
  block.samples_O = block_samples(half, 0);  // the plate's edges are far
  const double depth = block.inertia.mass * g * std::cos(slope) / (4 * hard_contact.stiffness);
  block.X_WO = lean * Pose{Eigen::Quaterniond::Identity(), start + Eigen::Vector3d(0, 0, half.z() - depth)};
  block.V_WO.v = lean.R * velocity;
  add(made, std::move(slope_body), ground);
  add(made, std::move(block), half);
  made.scene.duration = 1;
  return made;
}

/// Body 0 is the ground, the others are for the caller to pile up.
BenchmarkScene on_ground(double duration) {
  BenchmarkScene made;
  const Eigen::Vector3d ground{16, 16, 0.5};  // what is hit at 5 m/s must not fall off within 3 s
  made.scene.duration = duration;
  made.scene.body_contact = block_contact;
  add(made, plate(ground, 0.25), ground);
  return made;
}

}  // namespace

BenchmarkScene incline_benchmark(double degrees) {
  const double slope = degrees * std::numbers::pi / 180;
  const closed_form::Incline truth{.slope = slope, .gravity = g, .friction = friction};
  BenchmarkScene made = sliding(slope, {-1.5, 0, 0}, Eigen::Vector3d::Zero());
  made.title = fmt::format("block on a slope of {:g} degrees", degrees);
  made.plan = SlidePlan{.direction_W = made.scene.bodies[0].X_WO.R * Eigen::Vector3d::UnitX(),
                        .distance = closed_form::slip(truth, 1),
                        .at = 1};
  return made;
}

BenchmarkScene stopping_benchmark(double degrees) {
  const double angle = degrees * std::numbers::pi / 180, speed = 2;
  const Eigen::Vector3d direction{std::cos(angle), std::sin(angle), 0};
  BenchmarkScene made = sliding(0, {-0.3, -0.3, 0}, speed * direction);
  made.title = fmt::format("block stops, moving at {:g} degrees to the axes", degrees);
  const closed_form::Stopping truth{.speed = speed, .mu_dynamic = friction.mu_dynamic, .gravity = g};
  made.plan = SlidePlan{.direction_W = direction, .distance = closed_form::stop_distance(truth), .at = 1};
  return made;
}

BenchmarkScene tower(int wide, int high, double duration) {
  const int count = wide * wide * high;
  if (wide < 1 || high < 1 || count > 250)
    throw InputError(fmt::format("tower of {0} x {0} x {1} cubes: must be 1 to 250 of them", wide, high));
  constexpr double pitch = 0.0402;
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.02);
  BenchmarkScene made = on_ground(duration);
  Body cube = benchmark_block("cube", half, 0.0005, 0.05, friction);
  cube.samples_O = block_samples(half, 0.001);
  for (int k = 0; k < high; ++k)
    for (int i = 0; i < wide; ++i)
      for (int j = 0; j < wide; ++j) {
        cube.name = fmt::format("cube {} {} {}", i, j, k);
        cube.X_WO.p = {(i - (wide - 1) / 2.0) * pitch, (j - (wide - 1) / 2.0) * pitch, half.z() * (2 * k + 1)};
        add(made, cube, half);
      }
  made.title = fmt::format("tower of {} cubes at rest", count);
  made.scene.name = made.title;
  made.plan = TowerPlan{.settled = std::min(1.0, duration / 2), .until = duration};
  return made;
}

/// The axe is a hand: its palm is the head, the capsule of one phalanx the handle; they turn about an upright axis.
BenchmarkScene axe_benchmark() {
  constexpr int handle = 4;
  constexpr double duration = 4, swing_begin = 1, swing_time = 0.5, margin = 0.1, sample_rate = 500;
  HandModel model;
  model.capsules.fill({0.01, 0.005});
  model.capsules[handle] = {0.22, 0.012};
  model.palm_box.half_extents = {0.04, 0.03, 0.06};  // x up, y along the blow, z along the handle
  const Eigen::Quaterniond head_frame{(Eigen::Matrix3d() << 0, 1, 0, 0, 0, 1, 1, 0, 0).finished()};
  const Eigen::Quaterniond handle_frame{Eigen::AngleAxisd(-std::numbers::pi / 2, Eigen::Vector3d::UnitX())};
  const PoseFunction poses = [=](double t) {
    const double tau = std::clamp((t - swing_begin) / swing_time, 0.0, 1.0);
    const double angle = std::numbers::pi / 3 * (1 - 2 * tau * tau * tau * (10 + tau * (-15 + 6 * tau)));
    const Pose X_WAxe{Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())), {0, -0.6, 0.085}};
    std::array<Pose, phalanx_count> X_WP;
    X_WP.fill({Eigen::Quaterniond::Identity(), {0, 0, -10}});
    X_WP[palm] = X_WAxe * Pose{head_frame, {0, 0.6, 0}};
    X_WP[handle] = X_WAxe * Pose{handle_frame, {0, 0.32, 0}};
    return X_WP;
  };
  BenchmarkScene made = tower(5, 4, duration);
  made.title = "tower of 100 cubes hit by an axe";
  made.scene.contact = {.stiffness = 2000, .damping = 5};
  Hand axe;
  const Trace trace = sample_trace("axe", Side::right, model, poses, -margin, duration + margin, sample_rate);
  axe.motion = std::make_shared<TraceSpline>(trace, 0);
  made.scene.hands = {axe};
  made.phalanges = {{0, palm}, {0, handle}};
  made.plan = TowerPlan{.settled = 0.5, .until = swing_begin};
  return made;
}

BenchmarkScene jenga_benchmark() {
  const Eigen::Vector3d half{0.0375, 0.0124, 0.0075};
  constexpr double pitch = 0.025;
  BenchmarkScene made = on_ground(10);
  Body block = benchmark_block("block", half, 0.0005, 0.017, friction);
  block.samples_O = block_samples(half, 0.002);  // 0.1 mm off their neighbours' edges without the inset
  for (int k = 0; k < 18; ++k)
    for (int i = -1; i <= 1; ++i) {
      const bool across = k % 2 != 0;
      block.name = fmt::format("block {} {}", k, i + 1);
      block.X_WO.p = {across ? i * pitch : 0, across ? 0 : i * pitch, half.z() * (2 * k + 1)};
      block.X_WO.R = Eigen::AngleAxisd(across ? std::numbers::pi / 2 : 0, Eigen::Vector3d::UnitZ());
      add(made, block, half);
    }
  made.title = "18 layers of Jenga at rest";
  made.plan = TowerPlan{};
  return made;
}

}  // namespace handhold::catalogue
