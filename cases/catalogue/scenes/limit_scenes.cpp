// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/scenes/limit_scenes.hpp"

#include <cmath>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/closed_form/moved_pinch.hpp"

namespace handhold::catalogue {
namespace {

constexpr double share_of_critical = 0.45;
constexpr int samples = 16;  // of both fingers
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ(), forward = Eigen::Vector3d::UnitX();

const auto still = [](double) { return 0.0; };

/// Of each sample, so that all together damp their mass by the share.
double damping(double stiffness, double mass) { return 2 * share_of_critical * std::sqrt(stiffness * mass / samples); }

Scene pinched(const std::string& name, double duration, double stiffness, double mass, const Friction& friction,
              double normal_force, const SampleStart& start, const Path& path) {
  Scene scene;
  scene.name = name;
  scene.duration = duration;
  scene.contact = {stiffness, damping(stiffness, mass)};
  scene.bodies = {block({edge, edge, edge}, voxel, mass, friction)};
  const double depth = normal_force / (stiffness * samples / 2);
  scene.hands = {hand_of(pinch_patches(edge / 2, depth, start, still, path), duration)};
  return scene;
}

/// Starts with the hand's velocity and the lag of its weight; the hand's acceleration is zero then.
LimitScene shaken_pinch() {
  const closed_form::VerticalShake s{.amplitude = 0.01, .frequency = 25, .friction = {0.5, 0.5}};
  const double end = 0.36;  // after the stop at 0.277 s, before the next onset at 0.398 s
  LimitScene out{.name = "shaken pinch", .what = "D04: a pinch moves up and down by 10 mm at 25 rad/s; mu = 0.5"};
  out.scene = [=](double stiffness) {
    const Path path = [=](double t) -> Eigen::Vector3d { return s.amplitude * std::sin(s.frequency * t) * up; };
    const double lag = s.mass * s.gravity / (stiffness * samples);
    Scene scene =
        pinched("shaken pinch", end, stiffness, s.mass, s.friction, s.normal_force, {.lag_W = lag * up}, path);
    scene.bodies[0].V_WO.v = s.amplitude * s.frequency * up;
    return scene;
  };
  out.stiffness = {400, 1600, 6400};
  out.quantity = "slip of a period";
  out.unit = "m";
  out.measure = {.kind = Measure::Kind::displacement, .axis = -up, .at = end};
  out.truth = -slip(s);
  out.source = "L1: (c - g)(t - t1) = A w (cos w t - cos w t1) stops it";
  return out;
}

/// The hand moves on at constant speed from t = 0; friction brings the block up to it.
LimitScene pulled_grip() {
  constexpr double mass = 0.1, speed = 0.5, normal_force = 1, end = 0.2;
  const Friction friction{0.8, 0.6};
  LimitScene out{.name = "pulled grip", .what = "a pinch of 1 N a finger takes a block at rest along at 0.5 m/s"};
  out.scene = [=](double stiffness) {
    const Path path = [=](double t) -> Eigen::Vector3d { return speed * t * forward; };
    Scene scene = pinched("pulled grip", end, stiffness, mass, friction, normal_force, {}, path);
    scene.gravity.setZero();
    return scene;
  };
  out.stiffness = {200, 800, 3200};
  out.quantity = "slip";
  out.unit = "m";
  out.measure = {.kind = Measure::Kind::displacement, .axis = -forward, .at = end};
  out.truth = speed * speed * mass / (4 * friction.mu_dynamic * normal_force);
  out.source = "L1: V^2 / (2 a), a = 2 mu_d N / m";
  return out;
}

}  // namespace

const std::vector<LimitScene>& limit_scenes() {
  static const std::vector<LimitScene> scenes{shaken_pinch(), pulled_grip()};
  return scenes;
}

}  // namespace handhold::catalogue
