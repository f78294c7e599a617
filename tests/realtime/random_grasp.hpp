// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/mass_properties.hpp"
#include "cases/model/scene.hpp"
#include "realtime/world.hpp"

namespace handhold::realtime::testing {

/// The same numbers on every machine and with every standard library, unlike std::uniform_real_distribution.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {  // splitmix64
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  double uniform(double low = 0, double high = 1) { return low + (high - low) * double(bits() >> 11) * 0x1p-53; }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform()); }
  int below(int count) { return int(bits() % std::uint64_t(count)); }
  bool one_in(int count) { return below(count) == 0; }
  Eigen::Vector3d in_ball(double radius = 1) {
    for (;;) {
      const double x = uniform(-1, 1), y = uniform(-1, 1), z = uniform(-1, 1);
      const Eigen::Vector3d v(x, y, z);
      if (v.squaredNorm() <= 1) return radius * v;
    }
  }
  Eigen::Vector3d direction() {
    for (;;) {
      const Eigen::Vector3d v = in_ball();
      if (v.squaredNorm() > 1e-4) return v.normalized();
    }
  }

 private:
  std::uint64_t state_;
};

/// Objects to grasp, voxelized once.
struct GraspObject {
  std::shared_ptr<const VoxelField> field{};
  Inertia inertia{};  // of 1 kg
};

inline std::vector<GraspObject> grasp_objects() {
  const auto object = [](const Mesh& mesh, double voxel) {
    const SolidProperties solid = solid_properties(mesh);
    return GraspObject{voxelize(mesh, {.voxel_size = voxel}), {1, solid.center, solid.inertia / solid.volume}};
  };
  return {
      object(make_box({0.06, 0.05, 0.04}), 0.002), object(make_sphere(0.035, 3), 0.002),
      object(make_cylinder(0.03, 0.09, 32), 0.002),
      object(make_mug({.radius = 0.04, .height = 0.08, .wall = 0.006, .segments = 48}), 0.002),
      object(make_hammer({.handle_length = 0.2, .handle_radius = 0.014, .head = {0.09, 0.034, 0.034}, .segments = 16}),
             0.002)};
}

/// Random phalanges of one or two hands come from all sides to a body, 0 to 8 mm deep, squeeze, lift, shake and let go,
/// seen by a tracker that trembles and loses them.
class RandomGrasp {
 public:
  RandomGrasp(std::uint64_t seed, const std::vector<GraspObject>& objects) : random_(seed) {
    make_scene(objects);
    make_motion();
  }

  Scene scene{};
  Options options{};
  double dt{};
  int frames{};
  int order{1};

  /// Frame k, -2 to `frames`: to be asked for once each, in order.
  std::vector<HandFrame> next_frame() {
    const double s = double(k_++ - 2) / frames;  // 0 to 1
    std::vector<HandFrame> hands(scene.hands.size());
    const Pose carried = carry(s);
    for (std::size_t hand = 0; hand < hands.size(); ++hand) {
      HandFrame& frame = hands[hand];
      if (gap_[hand] > 0) --gap_[hand];
      frame.present = gap_[hand] == 0;
      if (frame.present && s > 0 && random_.uniform() < gap_rate_) gap_[hand] = 1 + random_.below(8);
      frame.X_WP.fill({Eigen::Quaterniond::Identity(), {0, 0, -10}});
    }
    for (const Finger& finger : fingers_) {
      Pose X = finger.X;
      X.p += finger.outward * way(s);
      X = carried * X;
      X.p += random_.in_ball(tremble_);
      X.R = (X.R * rotation_by(random_.in_ball(tremble_ / 0.02))).normalized();
      hands[std::size_t(finger.hand)].X_WP[std::size_t(finger.phalanx)] = X;
    }
    if (s > 0 && random_.uniform() < 0.2 * gap_rate_)  // what a tracker should not say, and some do
      hands[0].X_WP[std::size_t(random_.below(phalanx_count))].p.x() = std::numeric_limits<double>::quiet_NaN();
    return hands;
  }

 private:
  struct Finger {
    int hand{}, phalanx{};
    Pose X{};  // at the depth aimed at
    Eigen::Vector3d outward{};
    double depth{};
  };

  void make_scene(const std::vector<GraspObject>& objects) {
    const GraspObject& object = objects[std::size_t(random_.below(int(objects.size())))];
    scene.name = "random grasp";
    Body body;
    body.name = "object";
    body.field = object.field;
    body.inertia = object.inertia;
    body.inertia.mass = random_.log_uniform(0.01, 10);
    body.inertia.about_center *= body.inertia.mass;
    body.friction.mu_static = random_.uniform(0.05, 1.5);
    body.friction.mu_dynamic = body.friction.mu_static * (random_.one_in(4) ? 1 : random_.uniform());
    body.X_WO.R = rotation_by(random_.in_ball(std::numbers::pi)).normalized();
    body.X_WO.p = random_.in_ball(0.2);
    if (random_.one_in(4)) body.V_WO = {random_.in_ball(10), random_.in_ball(0.5)};
    scene.contact.stiffness = random_.log_uniform(10, 1e4);
    // Of 8 samples, from none to twice the critical damping.
    const double critical = 2 * std::sqrt(scene.contact.stiffness * body.inertia.mass / 8);
    scene.contact.damping = random_.one_in(4) ? 0 : random_.uniform(0, 2) * critical;
    if (random_.one_in(8)) scene.gravity.setZero();
    if (random_.one_in(8)) scene.patch.reference_point = ReferencePoint::centroid;
    if (random_.one_in(8)) scene.patch.samples = 1 + random_.below(12);
    dt = 1 / random_.log_uniform(45, 1000);
    frames = 30 + random_.below(40);
    options.substeps = 1 + random_.below(8);
    options.longest_bridge = dt * random_.uniform(1.2, 6);
    order = random_.one_in(8) ? 2 : 1;
    options.order = order;
    if (random_.one_in(2)) body.held_until = (std::floor(0.35 * frames) + 0.47 / options.substeps) * dt;
    scene.bodies = {body};
    scene.hands.resize(random_.one_in(3) ? 2 : 1);
    for (Hand& hand : scene.hands) hand.motion = shared_motion();
    gap_.assign(scene.hands.size(), 0);
  }

  /// Only its model is asked for.
  static std::shared_ptr<const HandMotion> shared_motion() {
    static const auto motion = [] {
      const PoseFunction nowhere = [](double) { return std::array<Pose, phalanx_count>{}; };
      return std::make_shared<const TraceSpline>(
          sample_trace("nobody", Side::right, anatomical_hand(), nowhere, -0.1, 0.1, 100), 0);
    }();
    return motion;
  }

  void make_motion() {
    const Body& body = scene.bodies[0];
    const Eigen::AlignedBox3d bounds = body.field->bounds();
    const int count = 1 + random_.below(6);
    for (int i = 0; i < count; ++i) {
      Finger finger;
      finger.hand = random_.below(int(scene.hands.size()));
      finger.phalanx = random_.below(phalanx_count);
      finger.outward = body.X_WO.R * random_.direction();
      const Eigen::Vector3d inside = bounds.center() + random_.in_ball().cwiseProduct(0.4 * bounds.sizes());
      const Eigen::Vector3d away = body.X_WO.R.conjugate() * finger.outward;
      const auto hit = body.field->raycast(inside + 0.5 * away, -away, 0.5);
      if (!hit) continue;
      finger.depth = random_.uniform(0, 0.008);
      const bool is_palm = finger.phalanx == palm;
      const HandModel model = anatomical_hand();
      const double thickness =
          is_palm ? model.palm_box.half_extents.y() : model.capsules[std::size_t(finger.phalanx)].radius;
      finger.X.p = body.X_WO * hit->p_O + (thickness - finger.depth) * finger.outward;
      // Its palm side (−y) faces the object, turned by anything about the way it comes, and tilted.
      const Eigen::Quaterniond facing = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), finger.outward);
      const Eigen::Vector3d about = random_.uniform(-3, 3) * Eigen::Vector3d::UnitY() + random_.in_ball(0.3);
      finger.X.R = (facing * rotation_by(about)).normalized();
      fingers_.push_back(finger);
    }
    approach_ = random_.uniform(0.01, 0.04);
    squeeze_ = random_.uniform(-0.001, 0.003);
    lift_ = random_.in_ball(0.1);
    turn_ = random_.in_ball(1.5);
    cycles_ = random_.uniform(0, 4);
    // At most 4 m/s: A ω = amplitude 2π cycles / (0.4 frames dt).
    const double fastest = 2 * std::numbers::pi * cycles_ / (0.4 * frames * dt);
    shake_ = random_.in_ball(std::min(0.03, 4 / std::max(fastest, 1.0)));
    tremble_ = random_.one_in(3) ? 0 : random_.log_uniform(1e-5, 5e-4);
    gap_rate_ = random_.one_in(2) ? 0 : 0.05;
  }

  static double ramp(double s) {
    const double x = std::clamp(s, 0.0, 1.0);
    return x * x * (3 - 2 * x);
  }
  /// From where a phalanx is at its depth, outwards: it comes, squeezes, and goes at last.
  [[nodiscard]] double way(double s) const {
    return approach_ * (1 - ramp(s / 0.25)) - squeeze_ * ramp((s - 0.25) / 0.1) +
           2 * approach_ * ramp((s - 0.85) / 0.15);
  }
  /// The hands' common motion.
  [[nodiscard]] Pose carry(double s) const {
    const double lift = ramp((s - 0.35) / 0.2), swing = std::clamp((s - 0.5) / 0.4, 0.0, 1.0);
    const double shaken = std::sin(2 * std::numbers::pi * cycles_ * swing) * ramp(4 * swing) * ramp(4 * (1 - swing));
    const Pose turn{rotation_by((lift + 0.3 * shaken) * turn_).normalized(), lift * lift_ + shaken * shake_};
    const Eigen::Vector3d about = scene.bodies[0].X_WO.p;
    return Pose{Eigen::Quaterniond::Identity(), about} * turn * Pose{Eigen::Quaterniond::Identity(), -about};
  }

  Random random_;
  int k_{};
  std::vector<Finger> fingers_{};
  std::vector<int> gap_{};
  double approach_{}, squeeze_{}, cycles_{}, tremble_{}, gap_rate_{};
  Eigen::Vector3d lift_{Eigen::Vector3d::Zero()}, turn_{Eigen::Vector3d::Zero()}, shake_{Eigen::Vector3d::Zero()};
};

}  // namespace handhold::realtime::testing
