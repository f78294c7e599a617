// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/planar_scenes.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include "cases/catalogue/builders/scenes.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::PlanarSlide;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int thumb = 2, index_finger = 5;  // distal phalanges

/// (u, v) = (z, x)
Vector3d in_space(const Vector2d& place, double y) { return {place.y(), y, place.x()}; }

MovingPatch finger(double side, const PlanarSlide& slide, const PlanarLayout& layout) {
  MovingPatch patch{side < 0 ? thumb : index_finger, {}, {}, [](double) -> Vector3d { return Vector3d::Zero(); }};
  const double face = layout.size.y() / 2;
  const Vector2d first{std::cos(slide.angle), std::sin(slide.angle)}, second{-first.y(), first.x()};
  for (std::size_t i = 0; i < slide.sticking.size(); ++i) {
    const PlanarSlide::Sticking& s = slide.sticking[i];
    const Vector2d anchor = slide.center + s.anchor_B.x() * first + s.anchor_B.y() * second;
    patch.p_W.push_back(in_space(s.p, side * (face - layout.stick_depth.at(i))));
    patch.start.push_back({.lag_W = in_space(s.p - anchor, 0)});
  }
  for (const PlanarSlide::Slipping& s : slide.slipping) {
    const Vector2d leash = s.leash * Vector2d{std::cos(s.direction), std::sin(s.direction)};
    patch.p_W.push_back(in_space(s.p, side * (face - s.leash / layout.friction.mu_dynamic)));
    patch.start.push_back({.lag_W = in_space(leash, 0), .slipping = true});
  }
  return patch;
}

}  // namespace

Scene planar_scene(const std::string& name, const PlanarSlide& slide, const PlanarLayout& layout, double duration) {
  Scene scene;
  scene.name = name;
  scene.duration = duration;
  scene.gravity = in_space(slide.gravity, 0);
  scene.contact = {.stiffness = layout.stiffness, .damping = 0};
  Body body = block(layout.size, layout.voxel_size, slide.mass, layout.friction);
  body.inertia.center = in_space(layout.center_B, 0);
  body.inertia.about_center = slide.inertia * Eigen::Matrix3d::Identity();
  body.X_WO.R = Eigen::AngleAxisd(slide.angle, Vector3d::UnitY());
  const Vector3d arm = body.X_WO.R * body.inertia.center;
  body.X_WO.p = in_space(slide.center, 0) - arm;
  body.V_WO.w = slide.spin * Vector3d::UnitY();
  body.V_WO.v = in_space(slide.velocity, 0) - body.V_WO.w.cross(arm);
  scene.bodies = {body};
  scene.hands = {hand_of({finger(-1, slide, layout), finger(1, slide, layout)}, duration)};
  return scene;
}

}  // namespace handhold::catalogue
