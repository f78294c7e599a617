// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/realtime/scenes.hpp"

// Orders of accuracy, in phases without a change of mode.

namespace handhold::realtime {
namespace {

using Eigen::Vector3d;
using namespace testing;  // NOLINT: this file's scenes

const auto still = [](double) -> Vector3d { return Vector3d::Zero(); };

/// A cube between two fingertips that stick: m x'' + C x' + K x = −m g from rest.
struct Oscillator {
  static constexpr double m = 0.2, K = 1600, C = 8;
  Scene scene;

  Oscillator() {
    scene.name = "oscillator";
    scene.bodies = {catalogue::block({catalogue::edge, catalogue::edge, catalogue::edge}, catalogue::voxel, m, {5, 5})};
    scene.contact = {.stiffness = K / 16, .damping = C / 16};
    const auto closed = [](double) { return 0.0; };
    scene.hands = {catalogue::hand_of(catalogue::pinch_patches(catalogue::edge / 2, 0.004, {}, closed, still), 1)};
  }
  [[nodiscard]] static double truth(double t) {
    const double decay = C / (2 * m), w = std::sqrt(K / m - decay * decay);
    return -m * 9.81 / K * (1 - std::exp(-decay * t) * (std::cos(w * t) + decay / w * std::sin(w * t)));
  }
  [[nodiscard]] double error(int order, int steps, double t) const {
    World world = started(scene, {.substeps = 1, .order = order}, t / steps);
    run(world, scene, steps, t / steps);
    EXPECT_EQ(world.unconverged(), 0);
    return std::abs(world.body().X_WO.p.z() - truth(t));
  }
};

TEST(Order, IsOneAndTwoForASpring) {
  const Oscillator oscillator;
  for (const int order : {1, 2}) {
    const double coarse = oscillator.error(order, 40, 0.05), fine = oscillator.error(order, 80, 0.05);
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.2);
  }
  EXPECT_LT(oscillator.error(2, 40, 0.05), 0.25 * oscillator.error(1, 40, 0.05));  // w h is 0.1: worth it
}

/// A cube that hangs from two points off its centre and swings by up to 90 degrees: geometry turns, springs stretch.
/// No closed form: the steps' own differences must fall by 2^order.
TEST(Order, IsOneAndTwoForASwing) {
  Scene scene;
  scene.name = "swing";
  scene.bodies = {catalogue::block({0.06, 0.06, 0.06}, 0.001, 0.2, {50, 50})};
  scene.contact = {.stiffness = 2000, .damping = 2};
  std::vector<catalogue::MovingPatch> patches;
  for (const double side : {-1.0, 1.0})
    patches.push_back({side < 0 ? 2 : 5, {Vector3d(0.02, side * 0.027, 0)}, {}, still});
  scene.hands = {catalogue::hand_of(patches, 1)};
  for (const int order : {1, 2}) {
    double angle[3]{};
    for (const int i : {0, 1, 2}) {
      const int steps = 100 << i;
      World world = started(scene, {.substeps = 1, .order = order}, 0.2 / steps);
      run(world, scene, steps, 0.2 / steps);
      const Eigen::Quaterniond& R = world.body().X_WO.R;
      angle[i] = 2 * std::atan2(R.y(), R.w());
    }
    EXPECT_GT(std::abs(angle[2]), 1);
    EXPECT_NEAR(std::log2((angle[0] - angle[1]) / (angle[1] - angle[2])), order, 0.2);
  }
}

/// x = a t²/2, exactly: the middle of a step has its mean velocity.
TEST(Order, TwoFallsExactly) {
  Scene scene;
  scene.name = "fall";
  scene.bodies = {catalogue::block({0.06, 0.06, 0.06}, 0.001, 0.2, {})};
  World world = started(scene, {.substeps = 1, .order = 2}, 1.0 / 90);
  run(world, scene, 45, 1.0 / 90);
  EXPECT_NEAR(world.body().X_WO.p.z(), -9.81 * 0.25 / 2, 1e-14);
}

/// F sin(w t) at the centre of mass of a body from rest: x = F/m (t/w − sin(w t)/w²); the work is the kinetic energy.
TEST(Order, LoadsActAndGiveTheirWork) {
  const double F = 0.3, w = 20, t = 0.2;  // not a whole period: errors would cancel
  Scene scene;
  scene.name = "load";
  scene.gravity.setZero();
  scene.bodies = {catalogue::block({0.06, 0.06, 0.06}, 0.001, 0.2, {})};
  scene.bodies[0].load = [=](double at) { return Load{{F * std::sin(w * at), 0, 0}, {0, 0, 1e-4}}; };
  const double truth = F / 0.2 * (t / w - std::sin(w * t) / (w * w));
  double error[2][2]{}, book[2][2]{};
  for (const int order : {1, 2})
    for (const int i : {0, 1}) {
      const int steps = 30 << i;
      World world = started(scene, {.substeps = 1, .order = order}, t / steps);
      run(world, scene, steps, t / steps);
      error[order - 1][i] = world.body().X_WO.p.x() - truth;
      const Energy e = world.energy();
      book[order - 1][i] = e.kinetic - e.hand_work;
      EXPECT_NEAR(world.body().w.z(), 1e-4 * t / scene.bodies[0].inertia.about_center(2, 2), 1e-12);
    }
  EXPECT_NEAR(std::log2(error[0][0] / error[0][1]), 1, 0.2);
  EXPECT_NEAR(std::log2(error[1][0] / error[1][1]), 2, 0.2);
  EXPECT_NEAR(std::log2(book[0][0] / book[0][1]), 1, 0.2);
  EXPECT_NEAR(book[1][0], 0, 1e-15);  // the middle's velocity times the force is the kinetic energy's change
}

/// The midpoint rule looks in the middle of a step: what is inside only at its end has touched, too.
TEST(Order, TwoTouchesInTheSecondHalfOfAStep) {
  for (int i = 0; i < 20; ++i) {
    Scene scene;
    scene.name = "fall";
    scene.bodies = {ground(), touching_block({0.04, 0.04, 0.04}, 0.1, 0.02)};
    scene.bodies[1].X_WO.p.z() = 0.02 + 0.02 + 0.001 * i;
    World world = started(scene, {.substeps = 1, .order = 2}, 1.0 / 90);
    for (int k = 1; k <= 20; ++k) {
      world.advance(1.0 / 90, {});
      bool touches = false;
      for (const Mode mode : world.contacts().mode) touches = touches || mode != Mode::apart;
      EXPECT_TRUE(touches || world.bodies()[1].X_WO.p.z() > 0.02 - 1e-9) << i << ", frame " << k;
    }
  }
}

}  // namespace
}  // namespace handhold::realtime
