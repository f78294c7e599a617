// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/l2/normal_shake_scene.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/scenes.hpp"

namespace handhold::catalogue {
namespace {

const Eigen::Vector3d normal = Eigen::Vector3d::UnitY(), up = Eigen::Vector3d::UnitZ();

}  // namespace

Scene normal_shake_scene(const closed_form::ShakenPinch& p, const Friction& friction, double gravity, double duration) {
  Scene scene;
  scene.name = fmt::format("pinch shaken along its normals by {:.6g} m", p.amplitude);
  scene.duration = duration;
  scene.gravity = -gravity * up;
  scene.contact = {.stiffness = p.stiffness / 8, .damping = 0};
  Body body = block({edge, edge, edge}, voxel, p.mass, friction);
  body.mobility = Mobility::translation;  // fingers that carry unlike loads would turn it
  body.V_WO.v = start_velocity(p) * normal;
  scene.bodies = {body};
  const Path path = [p](double t) -> Eigen::Vector3d { return p.amplitude * std::sin(p.frequency * t) * normal; };
  const auto no_grip = [](double) { return 0.0; };
  const SampleStart loaded{.lag_W = p.mass * gravity / (2 * p.stiffness) * up};
  scene.hands = {hand_of(pinch_patches(edge / 2, p.preload, loaded, no_grip, path), duration)};
  return scene;
}

}  // namespace handhold::catalogue
