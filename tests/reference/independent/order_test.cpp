// SPDX-License-Identifier: GPL-3.0-or-later
// The order of integration. The options offer no fixed step, but an accuracy so loose that it never asks for less than
// max_step makes the steps constant: the run then takes exactly duration / max_step of them, which is checked, and
// frames, at which a step must end, are only at both ends. Error against the independent solver.

#include <cmath>
#include <iostream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cases/catalogue/scenes/certification_scenes.hpp"
#include "reference/reference.hpp"
#include "tests/reference/independent/agreement.hpp"

namespace handhold::independent {
namespace {

Agreement error_at(const Scene& scene, const Result& truth, double step) {
  reference::Options options;
  options.accuracy = 1e-3;
  options.max_step = step;
  options.frame_rate = 1 / scene.duration;
  options.surface = reference::SurfaceModel::voxels;  // has no diagonals, at which an anchor's crossing ends a step
  const Recording recording = reference::simulate(scene, options);
  const std::string steps = std::to_string(std::lround(scene.duration / step));
  EXPECT_EQ(recording.provenance.at("steps"), steps);
  EXPECT_EQ(recording.provenance.at("steps attempted"), steps);
  return agreement(truth, recording);
}

// Runge-Kutta-Merson is of order 4. Errors fall from 4e-6 m to 6e-11 m, far above round-off.
TEST(Order, IsFourOnASmoothScene) {
  const Scene scene = catalogue::certification_scene("smooth").scene();
  const Result truth = solve(scene, nearest_face(*scene.bodies.front().field));
  ASSERT_TRUE(truth.events.empty());
  Agreement coarse = error_at(scene, truth, 0.004);
  for (const double step : {0.002, 0.001, 0.0005, 0.00025}) {
    const Agreement fine = error_at(scene, truth, step);
    const double position = std::log2(coarse.position / fine.position);
    const double rotation = std::log2(coarse.rotation / fine.rotation);
    std::cout << fmt::format("  step {:.2f} ms: {:.2e} m, order {:.3f}; {:.2e} rad, order {:.3f}\n", 1e3 * step,
                             fine.position, position, fine.rotation, rotation);
    EXPECT_NEAR(position, 4, 0.2);
    EXPECT_NEAR(rotation, 4, 0.2);
    coarse = fine;
  }
}

// Slip is a differential equation of its own (the anchor's): 4 there too, down to where round-off of 1e-15 m begins.
TEST(Order, IsFourWhileEverythingSlides) {
  const Scene scene = catalogue::certification_scene("slide").scene();
  const Result truth = solve(scene, nearest_face(*scene.bodies.front().field));
  ASSERT_TRUE(truth.events.empty());
  const double coarse = error_at(scene, truth, 0.004).position, fine = error_at(scene, truth, 0.001).position;
  const double order = std::log2(coarse / fine) / 2;
  std::cout << fmt::format("  4 ms to 1 ms: {:.2e} to {:.2e} m, order {:.3f}\n", coarse, fine, order);
  EXPECT_NEAR(order, 4, 0.2);
}

// With events, and steps that may be as long as they like, the accuracy governs (66 events). Between two accuracies a
// hundredfold apart the slope wanders with the luck of the steps, so four decades are spanned.
TEST(Order, ErrorIsProportionalToAccuracyThroughEvents) {
  const Scene scene = catalogue::certification_scene("twist16").scene();
  const Result truth = solve(scene, nearest_face(*scene.bodies.front().field));
  const auto error = [&](double accuracy) {
    reference::Options options;
    options.accuracy = accuracy;
    options.max_step = 5e-3;
    const Agreement a = agreement(truth, reference::simulate(scene, options));
    EXPECT_EQ(a.events_differ, "");
    return a.position;
  };
  const double loose = error(1e-6), tight = error(1e-10);
  const double slope = std::log10(loose / tight) / 4;
  std::cout << fmt::format("  accuracy 1e-6 to 1e-10: {:.1e} to {:.1e} m, slope {:.2f}\n", loose, tight, slope);
  // Order 4 in step with step ~ accuracy^(1/5) and a local error kept at the accuracy: between 4/5 and 1.
  EXPECT_GT(slope, 0.7);
  EXPECT_LT(slope, 1.1);
}

}  // namespace
}  // namespace handhold::independent
