// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/slider_scenes.hpp"

#include <cmath>

#include "cases/catalogue/builders/block_field.hpp"
#include "cases/catalogue/builders/scenes.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::Drive;
using closed_form::SliderOscillator;

constexpr double length = 1.0 / 4;          // of the palm's block [m]
constexpr double coarse_voxel = 1.0 / 256;  // [m]; the band is then 47 mm, room for deep fingers
constexpr int thumb = 2, index = 5;         // distal phalanges
const Eigen::Vector3d right = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitZ();

Body palm_block(const SliderOscillator& o) {
  Body body;
  body.name = "block";
  // Samples stay 15 voxels off every edge, where a C2 spline through the voxels feels nothing of it (0.27 a voxel).
  body.field = block_field(Eigen::Vector3d::Constant(length), coarse_voxel);
  body.inertia.mass = o.mass;
  body.inertia.about_center = o.mass * length * length / 6 * Eigen::Matrix3d::Identity();
  body.friction = o.friction;
  body.mobility = Mobility::translation;
  return body;
}

SampleStart start_of(const SliderOscillator& o, const Eigen::Vector3d& along) {
  // Undamped slip starts with the lag of the law; only the direction counts.
  const double stretch = o.direction != 0 && o.damping == 0 ? o.direction * 1e-3 : o.stretch;
  return {.lag_W = -stretch * along, .slipping = o.direction != 0};
}

/// A finger that presses on the block's end on side ±1 of x.
MovingPatch tether_finger(int phalanx, double side, double depth) {
  const Eigen::Vector3d p = side * (length / 2 - depth) * right + length / 2 * up;
  return {phalanx, {p}, {SampleStart{}}, {}};
}

/// The constant part of a force is gravity that leans; what is left is an applied load.
void apply(const Drive& force, const Eigen::Vector3d& along, Body& body) {
  Drive changing = force;
  changing.constant = 0;
  if (changing.rate == 0 && changing.curvature == 0 && changing.amplitude == 0) return;
  body.load = [=](double t) -> Load { return {.force_W = changing.value(t) * along}; };
}

}  // namespace

Scene palm_scene(const std::string& name, const SliderOscillator& o, const SliderLayout& layout, double duration) {
  Scene scene;
  scene.name = name;
  scene.duration = duration;
  scene.contact = {.stiffness = o.stiffness / layout.samples, .damping = o.damping / layout.samples};
  Body body = palm_block(o);
  body.X_WO.p = {o.x, 0, length / 2 - o.normal_force.constant / o.stiffness};
  body.V_WO.v = o.v * right;
  scene.gravity = (o.force.constant * right - o.normal_force.constant * up) / o.mass;
  apply(o.force, right, body);
  scene.bodies = {body};

  const Drive base = o.base;
  const Path path = [base](double t) -> Eigen::Vector3d { return (base.value(t) - base.value(0)) * right; };
  const auto points = ring(base.value(0) * right, up, right, 0.004, layout.samples);
  std::vector<MovingPatch> patches{{palm, points, std::vector<SampleStart>(points.size(), start_of(o, right)), path}};
  if (o.tether > 0) {
    patches.push_back(tether_finger(thumb, -1, layout.finger_depth));
    patches.push_back(tether_finger(index, 1, layout.finger_depth));
  }
  scene.hands = {hand_of(patches, duration)};
  return scene;
}

Scene pinch_scene(const std::string& name, const SliderOscillator& o, double duration) {
  constexpr double samples = 16;
  Scene scene;
  scene.name = name;
  scene.duration = duration;
  scene.contact = {.stiffness = o.stiffness / samples, .damping = o.damping / samples};
  Body body = block({edge, edge, 2 * edge}, voxel, o.mass, o.friction);
  body.X_WO.p = o.x * up;
  body.V_WO.v = o.v * up;
  scene.gravity = o.force.constant / o.mass * up;
  scene.bodies = {body};
  // N = K d + C d' of both fingers, so d = (N − C N'/K) / K while N' is constant.
  const double rate = o.normal_force.rate / o.stiffness;
  const double depth = (o.normal_force.constant - o.damping * rate) / o.stiffness;
  const Drive base = o.base;
  const Path path = [base](double t) -> Eigen::Vector3d { return (base.value(t) - base.value(0)) * up; };
  auto patches = pinch_patches(
      edge / 2, depth, start_of(o, up), [rate](double t) { return rate * t; }, path);
  for (MovingPatch& patch : patches)
    for (Eigen::Vector3d& p : patch.p_W) p += base.value(0) * up;
  scene.hands = {hand_of(patches, duration)};
  return scene;
}

void start_in_forced_stick(SliderOscillator& o) {
  using namespace closed_form;
  Forcing forcing;
  forcing.add(1, o.force).add(o.tether, o.tether_end).add_derivative(o.tether_damping, o.tether_end);
  forcing.add(o.stiffness, o.base).add_derivative(o.damping, o.base);
  const ForcedSolution forced({o.mass, o.damping + o.tether_damping, o.stiffness + o.tether}, forcing);
  o.x = forced.value(0);
  o.v = forced.derivative(0);
  o.stretch = o.x - o.base.value(0);
  o.direction = 0;
}

}  // namespace handhold::catalogue
