// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "cases/model/recording.hpp"
#include "compare/judge/gate.hpp"

// What a player of the benchmark scenes would see: measured from the poses of bodies and hands alone, so that any
// engine can be asked.

namespace handhold::compare {

/// A grip (S1, S2, S6). Motion is that of the object relative to the hand, both in W. NaN if the recording is too
/// short.
struct GripQuality {
  bool held{};                 ///< end < 10 mm, on the way < 20 mm, < 20 degrees away from where it was first held
  double penetration{};        ///< deepest phalanx, mean over the hold [m]
  double creep{};              ///< speed fitted to the hold [m/s]
  double shake_slip{};         ///< from before the shake to the end [m]
  double largest_deviation{};  ///< from where it was first held, at any time after [m]
};

[[nodiscard]] GripQuality grip_quality(const catalogue::BenchmarkScene& benchmark, const Recording& recording);

/// A block on a plate (S3).
struct SlideQuality {
  double distance{};  ///< along the plan's direction, at its instant [m]
  double lateral{};   ///< away from that line [m]
};

[[nodiscard]] SlideQuality slide_quality(const catalogue::BenchmarkScene& benchmark, const Recording& recording);

/// Blocks on the ground (S4).
struct TowerQuality {
  double sink{};           ///< farthest that any block moved to find its balance [m]
  double drift{};          ///< farthest that any block moved from then until the plan's end [m]
  bool stands{};           ///< until the plan's end no block moved by more than 10 mm from its start
  double largest_speed{};  ///< of any block at any time, from one frame to the next [m/s]
  double lowest{};         ///< height of the lowest centre at any time [m]
};

[[nodiscard]] TowerQuality tower_quality(const catalogue::BenchmarkScene& benchmark, const Recording& recording);

/// A pendulum between two fingertips (S5); angles are magnitudes from hanging.
struct SwingQuality {
  double half_period{};    ///< between the first two passes through hanging; NaN if there are none [s]
  double turning_angle{};  ///< where it is slowest for the first time after it was let go [rad]
  double swing_left{};     ///< largest angle of the last half second [rad]
  double pivot_slip{};     ///< farthest that the pivot moved, along the plane of the swing [m]
};

[[nodiscard]] SwingQuality swing_quality(const catalogue::BenchmarkScene& benchmark, const Recording& recording);

/// What the benchmark asks of the recording, with the bounds of docs/benchmarks.md.
[[nodiscard]] std::vector<Gate> quality_gates(const catalogue::BenchmarkScene& benchmark, const Recording& recording);

}  // namespace handhold::compare
