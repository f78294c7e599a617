// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "realtime/paper/middleware.hpp"

namespace handhold::realtime::paper::testing {

using Eigen::Vector3d;

constexpr double frame = 1.0 / 90;  // [s]

/// `count` points on a ring in the plane of `first` and `second` about the origin.
inline std::vector<Vector3d> ring(const Vector3d& first, const Vector3d& second, double radius, int count) {
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back(radius * (std::cos(angle) * first + std::sin(angle) * second));
  }
  return points;
}

inline Pose at(double x, double y, double z) { return {Eigen::Quaterniond::Identity(), {x, y, z}}; }

/// A box of voxels whose faces lie exactly where they should: sizes are powers of two.
inline std::shared_ptr<const Surface> box_surface(const Vector3d& size, double voxel, Normals normals) {
  const VoxelOptions options{.voxel_size = voxel, .band = 4 * voxel};
  return std::make_shared<FieldSurface>(voxelize(make_box(size), options), normals);
}

/// A face up, at z = top, endless or as the top of a box 2 m long: the real voxel field with its exact triangles.
struct FaceUp {
  std::shared_ptr<const Surface> surface{};
  double top{};
};

inline FaceUp face_up(const std::string& kind) {
  if (kind == "plane") return {std::make_shared<PlaneSurface>(0), 0};
  static const std::shared_ptr<const Surface> box = box_surface({2, 0.125, 0.0625}, 1.0 / 64, Normals::triangle);
  return {box, 0.03125};
}

/// One sample on a face at rest; the hand moves.
struct OneSample {
  Middleware law;
  double top, depth;

  OneSample(const FaceUp& face, double d, const Friction& friction, const Options& options, double x0 = 0)
      : law(face.surface, Vector3d::Zero(), friction, options, 1), top(face.top), depth(d) {
    const std::vector<Vector3d> point{Vector3d::Zero()};
    law.seed(0, at(x0, 0, top - d), {}, point, 0.02);
  }
  /// Tangential force with the hand at x.
  double push(double x) {
    const Pose hand = at(x, 0, top - depth);
    return law.frame(frame, std::span<const Pose>(&hand, 1), {}).force.x();
  }
  [[nodiscard]] const SampleState& sample() const { return law.patches()[0].samples[0]; }
};

}  // namespace handhold::realtime::paper::testing
