// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/scenes.hpp"

#include <cmath>
#include <memory>
#include <numbers>

#include "cases/catalogue/builders/block_field.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"

namespace handhold::catalogue {
namespace {

constexpr double sample_rate = 2000;  // [Hz]; the spline's error on a sine of 40 rad/s is then (ωΔ)⁴/384 = 4e-10 of it
constexpr double margin = 0.1;        // [s]; 200 samples, so that the natural ends are not felt

/// Palm side (−y) up, fingers along x.
const Eigen::Quaterniond palm_up{(Eigen::Matrix3d() << 0, 0, 1, -1, 0, 0, 0, -1, 0).finished()};

Pose phalanx_pose(int phalanx, const Eigen::Vector3d& center_W) {
  return {phalanx == palm ? palm_up : Eigen::Quaterniond::Identity(), center_W};
}

Eigen::Vector3d mean(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) sum += p;
  return sum / double(points.size());
}

}  // namespace

Body block(const Eigen::Vector3d& size, double voxel_size, double mass, const Friction& friction) {
  Body body;
  body.name = "block";
  body.field = block_field(size, voxel_size);
  body.inertia.mass = mass;
  const Eigen::Vector3d s = size.cwiseAbs2() * mass / 12;
  body.inertia.about_center = Eigen::Vector3d(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal();
  body.friction = friction;
  return body;
}

std::vector<Eigen::Vector3d> ring(const Eigen::Vector3d& center, const Eigen::Vector3d& axis,
                                  const Eigen::Vector3d& first, double radius, int count) {
  const Eigen::Vector3d second = axis.cross(first);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    points.push_back(center + radius * (std::cos(angle) * first + std::sin(angle) * second));
  }
  return points;
}

Hand hand_of(const std::vector<MovingPatch>& patches, double duration) {
  std::array<Pose, phalanx_count> start;
  std::array<Path, phalanx_count> paths;
  start.fill(phalanx_pose(palm, {0, 0, -1}));  // phalanges without a patch: out of the way
  Hand hand;
  for (const MovingPatch& patch : patches) {
    const Pose X_WP = phalanx_pose(patch.phalanx, mean(patch.p_W));
    start[patch.phalanx] = X_WP;
    paths[patch.phalanx] = patch.path;
    GivenPatch given{patch.phalanx, {}, patch.start};
    for (const Eigen::Vector3d& p_W : patch.p_W) given.p_P.push_back(X_WP.inverse() * p_W);
    hand.given.push_back(given);
  }
  const PoseFunction poses = [start, paths](double t) {
    std::array<Pose, phalanx_count> X_WP = start;
    for (int i = 0; i < phalanx_count; ++i)
      if (paths[i]) X_WP[i].p += paths[i](t);
    return X_WP;
  };
  const Trace trace =
      sample_trace("prescribed", Side::right, anatomical_hand(), poses, -margin, duration + margin, sample_rate);
  hand.motion = std::make_shared<TraceSpline>(trace, 0);
  return hand;
}

MovingPatch palm_patch(const SampleStart& start, const Path& path) {
  const auto points = ring({0, 0, 0}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), 0.02, 8);
  return {palm, points, std::vector<SampleStart>(points.size(), start), path};
}

std::vector<MovingPatch> pinch_patches(double half_gap, double depth, const SampleStart& start,
                                       const std::function<double(double)>& inwards, const Path& path) {
  constexpr int thumb = 2, index = 5;  // distal phalanges
  std::vector<MovingPatch> patches;
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d center = side * (half_gap - depth) * Eigen::Vector3d::UnitY();
    const auto points = ring(center, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), 0.004, 8);
    const Path moving = [=](double t) -> Eigen::Vector3d {
      return path(t) - side * inwards(t) * Eigen::Vector3d::UnitY();
    };
    patches.push_back({side < 0 ? thumb : index, points, std::vector<SampleStart>(points.size(), start), moving});
  }
  return patches;
}

}  // namespace handhold::catalogue
