// SPDX-License-Identifier: GPL-3.0-or-later
// Watching a world changes nothing of it, and every phase is told of.

#include <chrono>
#include <numeric>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "tests/realtime/scenes.hpp"

namespace handhold::realtime {
namespace {

using namespace testing;  // NOLINT: this file's scenes

TEST(PhaseClock, SeesAllOfAStepAndChangesNothing) {
  const Scene scene = catalogue::two_hand_grip({.phalanges = 6}).scene;
  constexpr double dt = 1.0 / 90;
  constexpr int substeps = 3;
  World watched = started(scene, {.substeps = substeps}, dt), other = started(scene, {.substeps = substeps}, dt);
  PhaseClock clock;
  watched.watch(&clock);
  for (int k = 1; k <= 60; ++k) {  // the fingers close until 0.5 s
    const std::vector<HandFrame> hands = frames(scene, k * dt);
    const auto start = std::chrono::steady_clock::now();
    clock.begin();
    watched.advance(dt, hands);
    const std::chrono::duration<double> all = std::chrono::steady_clock::now() - start;
    other.advance(dt, hands);
    EXPECT_LE(std::accumulate(clock.seconds().begin(), clock.seconds().end(), 0.0), all.count());
    for (std::size_t i = 0; i < phase_names.size(); ++i) {
      EXPECT_GE(clock.laps(Phase(i)), substeps) << phase_names[i];
      EXPECT_GT(clock.seconds()[i], 0) << phase_names[i];
    }
  }
  EXPECT_EQ(watched.body().X_WO.p, other.body().X_WO.p);
  EXPECT_EQ(watched.energy().hand_work, other.energy().hand_work);
  EXPECT_NE(watched.energy().hand_work, 0);  // it did touch
}

}  // namespace
}  // namespace handhold::realtime
