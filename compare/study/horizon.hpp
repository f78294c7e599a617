// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/engine/engine.hpp"

namespace handhold::compare {

/// How far aside the second run starts [m]: a hundredth of what the reference promises of a position (1e-7 m), ten
/// times what its integrator errs by in a step.
inline constexpr double horizon_shift = 1e-9;

/// Two runs that are this far apart have parted [m]: a thousand times the shift, so that it has been amplified and not
/// only kept; ten times what the reference promises of a position, so that its own error is not taken for it; a
/// hundredth of the least difference of engines that anybody asks for (0.1 mm).
inline constexpr double horizon_fork = 1e-6;

/// Until when a scene's answer means something: later than that, a start nobody can tell from this one has another.
struct Horizon {
  double t{};         ///< the last frame before the runs part [s]; the last that both have if they do not
  bool forks{false};  ///< whether they part
  double apart{};     ///< largest distance of any body's points up to `t` [m]
};

/// Where two runs of one scene part: no body's points are farther apart than `horizon_fork` up to there.
[[nodiscard]] Horizon horizon(const Scene& scene, const Recording& run, const Recording& beside);

/// Runs the scene once more with its first body that moves (of none: its first body) `horizon_shift` aside, in all
/// three directions alike, and compares with `run`, which `engine` made of the same scene and options.
[[nodiscard]] Horizon horizon(const Scene& scene, const Engine& engine, const EngineOptions& options,
                              const Recording& run, const Progress& progress = {});

}  // namespace handhold::compare
