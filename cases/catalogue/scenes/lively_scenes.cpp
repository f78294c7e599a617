// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/scenes/lively_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/hand/minimum_jerk.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::catalogue {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double finger_radius = 0.008, half_length = 0.012;  // [m]
constexpr double sample_rate = 250, margin = 0.1;             // of traces [Hz], [s]: see sample_trace
constexpr double palm_half_thickness = 0.012;                 // [m]

using Phalanges = std::array<Pose, phalanx_count>;

/// All of a hand's phalanges far away.
Phalanges absent() {
  Phalanges X_WP;
  X_WP.fill({Quaterniond::Identity(), {0, 0, -10}});
  return X_WP;
}

HandModel model() {
  HandModel made;
  made.capsules.fill({half_length, finger_radius});
  made.palm_box.half_extents = {0.045, palm_half_thickness, 0.045};
  return made;
}

Hand hand_of(Side side, const PoseFunction& poses, double duration) {
  const Trace trace = sample_trace("lively", side, model(), poses, -margin, duration + margin, sample_rate);
  Hand hand;
  hand.motion = std::make_shared<TraceSpline>(trace, 0);
  return hand;
}

/// From 0 to 1 between `begin` and `end`, at rest at both.
double ramp(double t, double begin, double end) { return minimum_jerk((t - begin) / (end - begin)); }

/// Palm side (−y) up, fingers along x.
const Quaterniond palm_up{(Eigen::Matrix3d() << 0, 0, 1, -1, 0, 0, 0, -1, 0).finished()};

/// Corners, moved inwards along x and y: cubes on each other would have corner on corner.
std::vector<Vector3d> corners(const Vector3d& half, double inset) {
  std::vector<Vector3d> points;
  for (const int z : {-1, 1})
    for (const int y : {-1, 1})
      for (const int x : {-1, 1}) points.emplace_back(x * (half.x() - inset), y * (half.y() - inset), z * half.z());
  return points;
}

/// Tips of thumb and index at ±y of `center`, `opening` [m] off the faces of a cube of edge 2 `half` (< 0: into them).
void pinch(const Vector3d& center, double half, double opening, Phalanges& X_WP) {
  constexpr int thumb = 2, index = 5;
  for (const int side : {-1, 1}) {
    const Vector3d p = center + side * (half + opening + finger_radius) * Vector3d::UnitY();
    X_WP[side < 0 ? thumb : index] = {Quaterniond(AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX())).conjugate(), p};
  }
}

}  // namespace

Scene box_in_hand() {
  const Vector3d half{0.035, 0.03, 0.015};
  const double overlap = 0.001;
  Scene scene;
  scene.name = "box in hand";
  scene.duration = 2;
  scene.contact = {.stiffness = 800, .damping = 1};
  Body box = block(2 * half, 0.002, 0.2, {0.6, 0.5});
  box.X_WO.p.z() = half.z() - 0.0005;
  box.held_until = 0.1;
  scene.bodies = {std::move(box)};
  const PoseFunction poses = [=](double t) {
    Phalanges X_HP = absent();  // H: the palm's upper face
    X_HP[palm] = {palm_up, {0, 0, -palm_half_thickness}};
    for (int finger = 1; finger < 5; ++finger) {
      const double y = 0.018 * (finger - 2.5), x = half.x() + finger_radius - overlap;
      X_HP[3 * finger] = {Quaterniond::Identity(), {x, y, 0.012}};
      // The last bones curl over the box's edge.
      const Quaterniond curl{AngleAxisd(-std::numbers::pi / 3, Vector3d::UnitY())};
      X_HP[3 * finger + 1] = {curl, {x - 0.006, y, 2 * half.z() + finger_radius - overlap}};
    }
    X_HP[1] = {Quaterniond(AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX())),
               {-half.x() - finger_radius + overlap, 0, 0.014}};
    // Up to 2 g sideways and upwards, and turned by 30 degrees.
    const double shaken = ramp(t, 0.3, 0.8), phase = 2 * std::numbers::pi * (t - 0.3);
    const Vector3d way{0.03 * std::sin(3 * phase), 0.02 * std::sin(2.3 * phase), 0.035 * std::sin(3.7 * phase)};
    const Vector3d turn{0.3 * std::sin(1.7 * phase), 0.5 * std::sin(1.1 * phase), 0.4 * std::sin(2.1 * phase)};
    const double angle = shaken * turn.norm();
    const Vector3d axis = angle > 0 ? Vector3d(turn.normalized()) : Vector3d(Vector3d::UnitX());
    const Pose X_WH{Quaterniond(AngleAxisd(angle, axis)), shaken * way};
    for (Pose& X : X_HP) X = X_WH * X;
    return X_HP;
  };
  scene.hands = {hand_of(Side::right, poses, scene.duration)};
  return scene;
}

Scene hand_to_hand() {
  const double half = 0.025, apart = 0.012, squeeze = -0.003;
  Scene scene;
  scene.name = "hand to hand";
  scene.duration = 2.4;
  scene.contact = {.stiffness = 1000, .damping = 2};
  Body cube = block(Vector3d::Constant(2 * half), 0.002, 0.1, {0.8, 0.7});
  cube.held_until = 0.35;
  scene.bodies = {std::move(cube)};
  const auto lift = [](double t) -> Vector3d { return {0, 0, 0.1 * ramp(t, 0.4, 0.9)}; };
  const PoseFunction first = [=](double t) {
    Phalanges X_WP = absent();
    const double opening = 0.01 + (squeeze - 0.01) * (ramp(t, 0, 0.3) - ramp(t, 1.5, 1.7));
    pinch(lift(t) + Vector3d(-apart - 0.1 * ramp(t, 1.7, 2), 0, 0), half, opening, X_WP);
    return X_WP;
  };
  const PoseFunction second = [=](double t) {
    Phalanges X_WP = absent();
    const double opening = 0.01 + (squeeze - 0.01) * ramp(t, 1.2, 1.4);
    pinch(lift(t) + Vector3d(apart + 0.1 * (1 - ramp(t, 0.9, 1.2)), 0, 0), half, opening, X_WP);
    const Pose carry{Quaterniond(AngleAxisd(ramp(t, 1.7, 2.3), Vector3d::UnitZ())),
                     Vector3d(0.15, 0.1, 0.05) * ramp(t, 1.7, 2.3)};
    for (const int tip : {2, 5}) X_WP[tip] = carry * X_WP[tip];
    return X_WP;
  };
  scene.hands = {hand_of(Side::left, first, scene.duration), hand_of(Side::right, second, scene.duration)};
  return scene;
}

Scene knocked_tower() {
  const Vector3d half = Vector3d::Constant(0.016), ground{0.5, 0.5, 0.0625};
  Scene scene;
  scene.name = "knocked tower";
  scene.duration = 1.6;
  scene.contact = {.stiffness = 1000, .damping = 2};
  Body plate = block(2 * ground, 1.0 / 64, 1, {0.5, 0.4});
  plate.name = "ground";
  plate.mobility = Mobility::fixed;
  plate.X_WO.p.z() = -ground.z();
  scene.bodies = {std::move(plate)};
  Body cube = block(2 * half, 0.001, 0.03, {0.5, 0.4});
  cube.samples_O = corners(half, 0.001);
  for (int i = 0; i < 10; ++i) {
    cube.name = fmt::format("cube {}", i);
    cube.X_WO.p = {0.001 * (i % 3 - 1), 0.0007 * (i % 2), half.z() * (2 * i + 1)};
    scene.bodies.push_back(cube);
  }
  // Four fingers, upright, come along x at up to 0.9 m/s.
  const PoseFunction knock = [](double t) {
    Phalanges X_WP = absent();
    const double x = -0.12 + 0.2 * ramp(t, 0.3, 0.7);
    for (int finger = 1; finger < 5; ++finger)
      X_WP[3 * finger + 2] = {Quaterniond(AngleAxisd(0.3, Vector3d::UnitY())), {x, 0.018 * (finger - 2.5), 0.18}};
    return X_WP;
  };
  // A palm that faces them.
  const PoseFunction wall = [](double t) {
    Phalanges X_WP = absent();
    const Quaterniond facing{AngleAxisd(-std::numbers::pi / 2, Vector3d::UnitZ())};  // its palm side, −y, to −x
    X_WP[palm] = {facing, {0.16 - 0.04 * ramp(t, 0.8, 1.2), 0, 0.1}};
    return X_WP;
  };
  scene.hands = {hand_of(Side::left, knock, scene.duration), hand_of(Side::right, wall, scene.duration)};
  return scene;
}

const std::vector<std::string>& lively_ids() {
  static const std::vector<std::string> ids{"box-in-hand", "hand-to-hand", "knocked-tower"};
  return ids;
}

Scene lively_scene(std::string_view id) {
  const std::vector<std::string>& ids = lively_ids();
  if (id == ids[0]) return box_in_hand();
  if (id == ids[1]) return hand_to_hand();
  if (id == ids[2]) return knocked_tower();
  throw InputError(
      fmt::format("lively scene '{}': there is none of that id (use one of {})", id, fmt::join(ids, ", ")));
}

}  // namespace handhold::catalogue
