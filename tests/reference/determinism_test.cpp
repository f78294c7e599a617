// SPDX-License-Identifier: GPL-3.0-or-later
// The same scene gives the same bits: again, in threads side by side, and whatever the order its patches are named in.

#include <algorithm>
#include <thread>

#include <gtest/gtest.h>

#include "tests/reference/scenes.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;
using namespace testing;

/// Three fingers and a palm hold and shake a cube that another, loose one touches: patches, slips, bodies.
Scene busy_scene() {
  Scene scene = cube_scene(0.15);
  scene.gravity = {0, 0, -gravity};
  scene.contact = {400, 0.5};
  scene.body_contact = {2000, 2};
  std::vector<Patch> patches;
  for (int i = 0; i < 4; ++i) {
    const double side = i % 2 == 0 ? -1 : 1, x = i < 2 ? 0.008 : -0.008;
    Patch patch;
    patch.phalanx = 3 * i + 2;
    for (const Vector3d& p : ring_z(0.004, 8)) patch.points.push_back({p.x(), 0, p.y()});
    patch.pose = [=](double t) {
      const Vector3d shake(0.004 * std::sin(25 * t), 0, 0.003 * std::sin(40 * t));
      return Pose{Eigen::Quaterniond::Identity(), shake + Vector3d(x, side * (half_edge - 0.0015), 0)};
    };
    patches.push_back(patch);
  }
  scene.hands.push_back(hand_with(patches, 0.25));
  Body loose = scene.bodies[0];
  loose.name = "loose";
  loose.X_WO.p = {0.01, 0, 2 * half_edge + 0.001};
  loose.V_WO = {{1, 2, 3}, {0, 0, -0.2}};
  loose.samples_O = {{-half_edge, -half_edge, -half_edge},
                     {half_edge, -half_edge, -half_edge},
                     {-half_edge, half_edge, -half_edge},
                     {half_edge, half_edge, -half_edge}};
  scene.bodies.push_back(loose);
  return scene;
}

void expect_same_bits(const Recording& a, const Recording& b) {
  ASSERT_EQ(a.outcome, b.outcome);
  ASSERT_EQ(a.frames.size(), b.frames.size());
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    const Frame &x = a.frames[i], &y = b.frames[i];
    for (std::size_t j = 0; j < x.bodies.size(); ++j) {
      ASSERT_EQ(x.bodies[j].X_WO.R.coeffs(), y.bodies[j].X_WO.R.coeffs());
      ASSERT_EQ(x.bodies[j].X_WO.p, y.bodies[j].X_WO.p);
      ASSERT_EQ(x.bodies[j].V_WO.w, y.bodies[j].V_WO.w);
    }
    ASSERT_EQ(x.contacts.size(), y.contacts.size());
    for (std::size_t j = 0; j < x.contacts.size(); ++j) {
      ASSERT_TRUE(x.contacts[j].id == y.contacts[j].id);
      ASSERT_EQ(x.contacts[j].f_W, y.contacts[j].f_W);
    }
    ASSERT_EQ(x.energy.dissipated, y.energy.dissipated);
  }
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    ASSERT_EQ(a.events[i].t, b.events[i].t);
    ASSERT_TRUE(a.events[i].id == b.events[i].id);
  }
}

TEST(Determinism, InFourThreads) {
  const Scene scene = busy_scene();
  const Recording alone = simulate(scene, {});
  ASSERT_EQ(alone.outcome, Outcome::complete) << alone.note;
  EXPECT_GT(alone.events.size(), 20u);
  std::vector<Recording> recordings(4);
  std::vector<std::thread> threads;
  for (Recording& r : recordings) threads.emplace_back([&] { r = simulate(scene, {}); });
  for (std::thread& thread : threads) thread.join();
  for (const Recording& r : recordings) expect_same_bits(alone, r);
}

TEST(Determinism, WhateverTheOrderOfPhalanges) {
  Scene scene = busy_scene();
  const Recording before = simulate(scene, {});
  std::reverse(scene.hands[0].given.begin(), scene.hands[0].given.end());
  std::swap(scene.hands[0].given[0], scene.hands[0].given[2]);
  expect_same_bits(before, simulate(scene, {}));
}

}  // namespace
}  // namespace handhold::reference
