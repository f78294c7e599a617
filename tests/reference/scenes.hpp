// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Scenes with closed forms. Edges and voxels are powers of two, so that the float distances of flat faces are exact;
// the band is 24 voxels wide, so that its clamp moves the spline by less than 0.27^24 voxels, round-off.

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"
#include "reference/reference.hpp"

namespace handhold::reference::testing {

inline constexpr double half_edge = 1.0 / 32;  // [m]
inline constexpr double gravity = 9.81;

inline std::shared_ptr<const VoxelField> cube_field() {
  static const auto field = voxelize(make_box(Eigen::Vector3d::Constant(2 * half_edge)), {1.0 / 1024, 24.0 / 1024});
  return field;
}

/// A cube of 0.2 kg at rest at the origin, not under gravity.
inline Scene cube_scene(double duration) {
  Scene scene;
  scene.name = "test";
  scene.duration = duration;
  scene.gravity.setZero();
  scene.contact = {400, 0};
  Body body;
  body.name = "cube";
  body.field = cube_field();
  body.inertia.mass = 0.2;
  body.inertia.about_center = Eigen::Vector3d::Constant(0.2 * 4 * half_edge * half_edge / 6).asDiagonal();
  body.friction = {0.5, 0.4};
  scene.bodies.push_back(body);
  return scene;
}

using Motion = std::function<Pose(double t)>;

struct Patch {
  int phalanx{palm};
  std::vector<Eigen::Vector3d> points{};  ///< in the phalanx's frame
  SampleStart start{};
  Motion pose = [](double) { return Pose(); };
};

/// A hand with these patches only; motion sampled at 4 kHz: cubic splines of sines up to 40 rad/s err by 3e-11 of them.
inline Hand hand_with(const std::vector<Patch>& patches, double end, double begin = -0.1, double rate = 4000) {
  Hand hand;
  for (const Patch& patch : patches)
    hand.given.push_back({patch.phalanx, patch.points, std::vector<SampleStart>(patch.points.size(), patch.start)});
  const PoseFunction poses = [patches](double t) {
    std::array<Pose, phalanx_count> all;
    all.fill(Pose{Eigen::Quaterniond::Identity(), {0, 0, -10}});
    for (const Patch& patch : patches) all[std::size_t(patch.phalanx)] = patch.pose(t);
    return all;
  };
  const Trace trace = sample_trace("test", Side::right, anatomical_hand(), poses, begin, end, rate);
  hand.motion = std::make_shared<TraceSpline>(trace, 0);
  return hand;
}

inline std::vector<Eigen::Vector3d> square(double half_side) {
  return {
      {-half_side, -half_side, 0}, {half_side, -half_side, 0}, {-half_side, half_side, 0}, {half_side, half_side, 0}};
}

inline std::vector<Eigen::Vector3d> ring_z(double radius, int count) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / count;
    points.push_back(radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  return points;
}

/// The cube lies on a palm of four samples, in equilibrium: m g = 4 k d.
inline Scene palm_scene(double duration, const SampleStart& start = {}) {
  Scene scene = cube_scene(duration);
  scene.gravity = {0, 0, -gravity};
  const double depth = 0.2 * gravity / (4 * scene.contact.stiffness);
  scene.bodies[0].X_WO.p.z() = half_edge - depth;
  Patch patch;
  patch.points = square(0.008);
  patch.start = start;
  scene.hands.push_back(hand_with({patch}, duration + 0.1));
  return scene;
}

inline double palm_depth() { return 0.2 * gravity / (4 * 400); }

}  // namespace handhold::reference::testing
