// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "tests/realtime/scenes.hpp"

// What the time step makes of sliding under constant friction: the blocks of S3, against the exact maps of both
// schemes. With h the step and a the acceleration, velocities are exact in both, v_n = v_0 + n a h. The first order
// moves a body by h v_(n+1) a step, the second by h (v_n + v_(n+1))/2, but in a step in which a contact changes its
// mode and in the next one: in the first two of all, since the block touches, and from the one on in which it stops.

namespace handhold::realtime {
namespace {

using namespace testing;  // NOLINT: this file's scenes

constexpr double mu = 0.5, g = 9.81, speed = 2, half_kilogram = 0.5;
constexpr double frame = 1.0 / 90;

struct Slid {
  double along{}, aside{};  // [m]
};

Slid slide(const std::string& id, int order, int substeps) {
  const catalogue::BenchmarkScene made = catalogue::benchmark_scene(id);
  World world = started(made.scene, {.substeps = substeps, .order = order}, frame);
  const Eigen::Vector3d begin = world.bodies()[1].center();
  run(world, made.scene, 90, frame);
  EXPECT_EQ(world.unconverged(), 0);
  const Eigen::Vector3d direction = std::get<catalogue::SlidePlan>(made.plan).direction_W;
  const Eigen::Vector3d way = world.bodies()[1].center() - begin;
  return {way.dot(direction), (way - way.dot(direction) * direction).norm()};
}

/// On a slope the first order is ahead by half a step's share of the speed at the end, h/t of the distance; the second
/// by its first two steps, 2 (h/t)² of it.
TEST(SlidingBlock, DownASlopeIsAheadByTheSchemesOwnShare) {
  for (const int degrees : {30, 45})
    for (const int substeps : {2, 4}) {
      const double angle = degrees * std::numbers::pi / 180, t = 1, h = frame / substeps;
      const double truth = 0.5 * g * (std::sin(angle) - mu * std::cos(angle)) * t * t;
      const std::string id = "S3-" + std::to_string(degrees);
      // Rounding of 180 steps, friction that the springs follow to the last bit but for the solver's 1e-13.
      EXPECT_NEAR(slide(id, 1, substeps).along / truth, 1 + h / t, 1e-8) << id;
      EXPECT_NEAR(slide(id, 2, substeps).along / truth, 1 + 2 * h * h / (t * t), 1e-8) << id;
    }
}

/// Way of the N whole steps before the one in which the block stops, and does not move any more.
double stopping_way(int order, double h) {
  const double a = mu * g, steps = std::floor(speed / (a * h)), t = steps * h;
  const double truth = speed * t - 0.5 * a * t * t;
  return truth - 0.5 * a * h * (order == 1 ? t : 2 * h);
}

/// The first order stops short by half a step's way at the first speed, a h/v of the distance, whatever the direction.
TEST(SlidingBlock, StopsWhereTheSchemeSaysInEveryDirection) {
  const double lag = mu * half_kilogram * g / 8e5;  // of the springs of four corners, given back after the stop: K
  for (const int substeps : {2, 4})
    for (const int order : {1, 2})
      for (const char* degrees : {"0", "30", "45"}) {
        const Slid slid = slide(std::string("S3-stop-") + degrees, order, substeps);
        EXPECT_NEAR(slid.along, stopping_way(order, frame / substeps), 2 * lag) << degrees << " order " << order;
        EXPECT_LT(slid.aside, 1e-12);  // rounding: friction is opposite to the velocity
      }
}

/// Implicit Euler loses m |Δv|²/2 in each of its steps, the midpoint rule nothing: of the second order, two steps lose.
/// The springs that carry the weight were loaded before they were seen to touch: N²/(2 K) appears.
TEST(SlidingBlock, LosesEnergyInEulersStepsAlone) {
  const int substeps = 2, steps = 90 * substeps;
  const double h = frame / substeps, a = g * (std::sin(std::numbers::pi / 4) - mu * std::cos(std::numbers::pi / 4));
  const double loss = 0.5 * half_kilogram * a * h * a * h;
  const double weight = half_kilogram * g * std::cos(std::numbers::pi / 4), loaded = weight * weight / (2 * 8e5);
  const catalogue::BenchmarkScene made = catalogue::benchmark_scene("S3-45");
  for (const int order : {1, 2}) {
    World world = started(made.scene, {.substeps = substeps, .order = order}, frame);
    run(world, made.scene, 90, frame);
    const double book = energy_sum(world.energy());
    // Euler's steps may lose as much as the springs along the slope hold, μ² of the others', 1 % of `loss`.
    EXPECT_NEAR(book, loaded - loss * (order == 1 ? steps : 2), mu * mu * loaded) << order;
  }
}

/// What the benchmark asks for: 0.1 % of the distance, with the second order at as few sub-steps as 2.
TEST(SlidingBlock, IsWithinATenthOfAPercentWithTheSecondOrder) {
  const double truth = speed * speed / (2 * mu * g);
  for (const int substeps : {2, 4})
    for (const char* degrees : {"0", "30", "45"})
      EXPECT_NEAR(slide(std::string("S3-stop-") + degrees, 2, substeps).along, truth, 1e-3 * truth) << degrees;
  for (const int order : {1, 2})
    for (const char* degrees : {"24", "26"})
      EXPECT_LT(std::abs(slide(std::string("S3-") + degrees, order, 4).along), 1e-4) << degrees;
}

}  // namespace
}  // namespace handhold::realtime
