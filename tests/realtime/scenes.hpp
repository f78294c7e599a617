// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/geometry/surface_samples.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "realtime/world.hpp"

namespace handhold::realtime::testing {

using Eigen::Vector3d;

inline std::vector<HandFrame> frames(const Scene& scene, double t) {
  std::vector<HandFrame> hands(scene.hands.size());
  for (std::size_t i = 0; i < hands.size(); ++i) {
    hands[i].present = true;
    for (int p = 0; p < phalanx_count; ++p) hands[i].X_WP[std::size_t(p)] = scene.hands[i].motion->pose(p, t);
  }
  return hands;
}

inline World started(const Scene& scene, const Options& options, double dt) {
  World world(world_def_of(scene), options);
  for (const double t : {-2 * dt, -dt}) world.observe(dt, frames(scene, t));
  world.start(dt, frames(scene, 0));
  return world;
}

inline void run(World& world, const Scene& scene, int count, double dt) {
  for (int k = 1; k <= count; ++k) world.advance(dt, frames(scene, k * dt));
}

/// A block that touches with samples `spacing` apart.
inline Body touching_block(const Vector3d& size, double mass, double spacing, double voxel = 0.001) {
  Body body = catalogue::block(size, voxel, mass, {0.5, 0.5});
  body.samples_O = surface_samples(make_box(size), spacing);
  return body;
}

/// Its upper face is z = 0.
inline Body ground(const Vector3d& size = {0.5, 0.5, 0.05}, double voxel = 0.002) {
  Body body = catalogue::block(size, voxel, 1, {0.5, 0.5});
  body.mobility = Mobility::fixed;
  body.X_WO.p.z() = -size.z() / 2;
  return body;
}

/// Shortens the names of the tests' scenes: one layer above the other, turned by 90 degrees, on the ground.
inline Scene blocks(int layers, int in_a_layer) {
  Scene scene;
  scene.name = "blocks";
  scene.bodies = {ground({0.2, 0.2, 0.02})};
  const Vector3d size(0.075, 0.0248, 0.015);
  const Body block = touching_block(size, 0.017, 0.0124);
  for (int k = 0; k < layers; ++k)
    for (int i = 0; i < in_a_layer; ++i) {
      Body body = block;
      const double aside = 0.025 * (i - 0.5 * (in_a_layer - 1));
      body.X_WO.p = {k % 2 ? aside : 0, k % 2 ? 0 : aside, size.z() * (k + 0.5)};
      if (k % 2) body.X_WO.R = Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ());
      scene.bodies.push_back(body);
    }
  return scene;
}

/// A phalanx alone, along `path` in W; the others of its hand are far away.
inline Hand finger(const catalogue::Path& path, const Vector3d& at, double duration) {
  Hand hand = catalogue::hand_of({{5, {at}, {}, path}}, duration);
  hand.given.clear();
  return hand;
}

}  // namespace handhold::realtime::testing
