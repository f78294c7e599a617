// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/random_scene.hpp"

#include <array>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/surface_samples.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"
#include "cases/model/mass_properties.hpp"

namespace handhold::reference {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

struct Shape {
  std::shared_ptr<const VoxelField> field{};
  double sample_spacing{};  // [m]
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = [] {
    const VoxelOptions coarse{0.002, 0.024};
    std::vector<Shape> made;
    const auto add = [&](const Mesh& mesh, double spacing) { made.push_back({voxelize(mesh, coarse), spacing}); };
    add(make_box({0.06, 0.06, 0.06}), 0.06);
    add(make_box({0.3, 0.2, 0.05}), 0.1);
    add(make_sphere(0.03, 2), 0.03);
    add(make_l_shape(0.08, 0.06, 0.02, 0.04), 0.04);
    add(make_cylinder(0.03, 0.08, 12), 0.04);
    return made;
  }();
  return all;
}

}  // namespace

Quaterniond RandomScene::turn() {
  if (flip(0.4)) return Quaterniond::Identity();
  return Quaterniond(in(-1, 1), in(-1, 1), in(-1, 1), in(0.1, 1)).normalized();
}

Body RandomScene::body(int index) {
  const Shape& shape = shapes()[std::size_t(count(0, int(shapes().size()) - 1))];
  Body body;
  body.name = "body " + std::to_string(index);
  body.field = shape.field;
  const SolidProperties solid = solid_properties(shape.field->mesh());
  const double density = log_in(50, 5000);
  body.inertia = {density * solid.volume, solid.center, density * solid.inertia};
  body.mobility = flip(0.6) ? Mobility::free : flip(0.5) ? Mobility::translation : Mobility::fixed;
  const double mu = flip(0.1) ? 0 : in(0, 1.2);
  body.friction = {mu, flip(0.3) ? mu : mu * in(0, 1)};
  body.X_WO = {turn(), vector(0.06)};
  if (flip(0.2) && body.mobility != Mobility::fixed) body.held_until = in(0, 0.1);
  if (body.held_until == 0 && body.mobility != Mobility::fixed) {
    body.V_WO.v = vector(flip(0.5) ? 0.5 : 0);
    if (body.mobility == Mobility::free) body.V_WO.w = vector(flip(0.5) ? 10 : 0);
  }
  if (flip(0.6)) body.samples_O = surface_samples(shape.field->mesh(), shape.sample_spacing);
  if (flip(0.2)) {
    const Vector3d force = vector(1), torque = vector(0.01);
    body.load = [=](double t) { return Load{force * std::sin(20 * t), torque}; };
  }
  return body;
}

Hand RandomScene::hand(double duration) {
  const Vector3d from = vector(0.1), sway = vector(0.05);
  const Quaterniond orientation = turn();
  const double rate = in(1, 10);
  const PoseFunction poses = [=](double t) {
    std::array<Pose, phalanx_count> all;
    for (int i = 0; i < phalanx_count; ++i) {
      const Vector3d place = from + sway * std::sin(rate * t + i) + 0.02 * Vector3d(i % 4 - 1.5, i / 4 - 1.5, 0);
      all[std::size_t(i)] = {orientation, place};
    }
    return all;
  };
  const bool late = flip(0.2);
  const double begin = late ? 0.3 * duration : -0.1, end = late ? 0.8 * duration : duration + 0.1;
  Hand hand;
  hand.motion = std::make_shared<TraceSpline>(
      sample_trace("fuzz", Side::right, anatomical_hand(), poses, begin, end, in(200, 500)), 0);
  if (flip(0.5)) return hand;
  for (int i = 0; i < 3; ++i) {
    GivenPatch patch;
    patch.phalanx = 5 * i;
    for (int k = count(1, 8); k > 0; --k) patch.p_P.push_back(vector(0.01));
    if (flip(0.5)) patch.start.assign(patch.p_P.size(), {vector(0.002), flip(0.5)});
    hand.given.push_back(patch);
  }
  return hand;
}

RandomScene::Result RandomScene::make() {
  Result result;
  Scene& scene = result.scene;
  scene.name = "fuzz";
  scene.duration = log_in(0.01, 0.15);
  if (flip(0.2)) scene.gravity.setZero();
  scene.contact = {log_in(50, 2000), flip(0.3) ? 0 : log_in(0.01, 5)};
  scene.body_contact = {log_in(200, 2e4), flip(0.3) ? 0 : log_in(0.1, 50)};
  scene.patch.samples = count(1, 8);
  scene.patch.reference_point = flip(0.8) ? ReferencePoint::skin : ReferencePoint::centroid;
  for (int i = count(1, 4); i > 0; --i) scene.bodies.push_back(body(i));
  for (int i = count(0, 2); i > 0; --i) scene.hands.push_back(hand(scene.duration));
  if (flip(0.3)) result.spoiled = spoil(scene);
  return result;
}

std::string RandomScene::spoil(Scene& scene) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Body& body = scene.bodies.back();
  body.mobility = Mobility::free;
  const std::vector<std::pair<const char*, std::function<void()>>> ways{
      {"mass -1", [&] { body.inertia.mass = -1; }},
      {"mass NaN", [&] { body.inertia.mass = nan; }},
      {"mass 0", [&] { body.inertia.mass = 0; }},
      {"inertia 0", [&] { body.inertia.about_center.setZero(); }},
      {"inertia NaN", [&] { body.inertia.about_center(0, 1) = nan; }},
      {"inertia of no solid", [&] { body.inertia.about_center = Vector3d(1, 1, 3).asDiagonal(); }},
      {"position NaN", [&] { body.X_WO.p.x() = nan; }},
      {"orientation NaN", [&] { body.X_WO.R.x() = nan; }},
      {"orientation not unit", [&] { body.X_WO.R.coeffs() *= 1.1; }},
      {"velocity infinite", [&] { body.V_WO.v.x() = std::numeric_limits<double>::infinity(); }},
      {"spin NaN", [&] { body.V_WO.w.x() = nan; }},
      {"no field", [&] { body.field = nullptr; }},
      {"friction reversed",
       [&] {
         body.friction = {0.2, 0.3};
       }},
      {"friction NaN",
       [&] {
         body.friction = {nan, 0.3};
       }},
      {"sample NaN",
       [&] {
         body.samples_O.push_back({0, nan, 0});
       }},
      {"too many samples", [&] { body.samples_O.assign(256, Vector3d::Zero()); }},
      {"held until -1", [&] { body.held_until = -1; }},
      {"load NaN", [&] { body.load = [=](double) {
                           return Load{{nan, 0, 0}, {0, 0, 0}};
                         }; }},
      {"duration -1", [&] { scene.duration = -1; }},
      {"duration NaN", [&] { scene.duration = nan; }},
      {"gravity NaN", [&] { scene.gravity.y() = nan; }},
      {"stiffness 0", [&] { scene.contact.stiffness = 0; }},
      {"damping -1", [&] { scene.body_contact.damping = -1; }},
      {"no bodies", [&] { scene.bodies.clear(); }},
      {"a name twice", [&] { scene.bodies.push_back(scene.bodies.back()); }},
      {"a hand without motion", [&] { scene.hands.emplace_back(); }},
      {"no samples a patch", [&] { scene.patch.samples = 0; }},
      {"offset beyond the band", [&] { scene.patch.contact_offset = 0.03; }},
  };
  const auto& way = ways[std::size_t(count(0, int(ways.size()) - 1))];
  way.second();
  return way.first;
}

}  // namespace handhold::reference
