#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "realtime/paper/host.hpp"

namespace handhold::realtime::paper::testing {

using Eigen::Vector3d;

constexpr double frame = 1.0 / 90;  // [s]
constexpr double gravity = 9.81;    // [m/s²]
constexpr double exact = 1e-12;     // relative: the bound asked of this law's exact maps

/// Largest relative error of a test; ends up in its XML or JSON as "worst_relative_error".
class Worst {
 public:
  ~Worst() {
    std::ostringstream text;
    text << worst_;
    ::testing::Test::RecordProperty("worst_relative_error", text.str());
  }
  void expect(double value, double truth, double tolerance = exact) {
    const double error = std::abs(value - truth) / std::abs(truth);
    worst_ = std::max(worst_, error);
    EXPECT_LE(error, tolerance) << value << " instead of " << truth;
  }

 private:
  double worst_{0};
};

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

/// Faces at x = ±1/32 between two fingers.
inline std::shared_ptr<const Surface> slab(const std::string& kind) {
  if (kind == "plane") return std::make_shared<SlabSurface>(0.03125);
  static const std::shared_ptr<const Surface> box = box_surface({0.0625, 0.125, 2}, 1.0 / 64, Normals::triangle);
  return box;
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

/// An object that two fingers pinch at x = ±(1/32 − depth); it can only translate.
struct Pinch {
  Host host;
  std::array<Pose, 2> hands{};
  int samples;

  Pinch(const std::string& kind, double depth, double mass, const Friction& friction, const Options& options,
        int samples_each = 8, const HostOptions& host_options = {})
      : host(Middleware(slab(kind), Vector3d::Zero(), friction, options, 2), body(mass), {0, 0, -gravity},
             host_options),
        samples(samples_each) {
    close(depth);
    const auto points = ring(Vector3d::UnitY(), Vector3d::UnitZ(), 0.004, samples);
    for (int i = 0; i < 2; ++i) host.middleware().seed(i, hands[std::size_t(i)], {}, points, 0.02);
  }
  static HostBody body(double mass) {
    HostBody b;
    b.mass = mass;
    b.mobility = Mobility::translation;
    return b;
  }
  void close(double depth) { hands = {at(-0.03125 + depth, 0, 0), at(0.03125 - depth, 0, 0)}; }
  /// Gives every sample the lag that carries upwards with γ lag.
  void set_lag(double lag, Mode mode) {
    for (int k = 0; k < 2; ++k)
      for (int i = 0; i < samples; ++i) {
        Spot spot = host.middleware().patches()[std::size_t(k)].samples[std::size_t(i)].anchor;
        spot.C_O.z() -= lag;
        host.middleware().set(k, i, spot, mode);
      }
  }
  void advance(double dt) { host.advance(dt, hands); }
  [[nodiscard]] double fall() const { return -host.body().motion.X_WO.p.z(); }
  [[nodiscard]] double speed() const { return -host.body().motion.v.z(); }
  [[nodiscard]] bool slips() const { return host.middleware().patches()[0].samples[0].mode == Mode::slip; }
};

}  // namespace handhold::realtime::paper::testing
