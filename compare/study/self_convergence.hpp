// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"
#include "compare/engine/engine.hpp"
#include "compare/study/convergence.hpp"

namespace handhold::compare {

/// How far two answers to one scene are apart: at their ends, and in the changes of mode of every sample.
struct Gap {
  double position{};     ///< of the origin of any body at the end [m]
  double rotation{};     ///< of any body at the end [rad]
  double event_time{};   ///< the worst over samples whose lists of kinds agree, in order [s]
  int unlike_samples{};  ///< samples whose lists of kinds differ, in kind, order or length
};

/// NaN throughout if a recording has no frame, or their bodies are not the same in number.
[[nodiscard]] Gap gap(const Recording& a, const Recording& b);

/// One way to run an engine.
struct Setting {
  std::string name{};
  EngineOptions options{};
  double size{};                 ///< what the error should shrink with: accuracy, or sub-step [s]
  std::optional<Gap> promise{};  ///< what this setting is said to keep
};

/// Accuracies 1e-6 and 1e-8, the presets "reference" (1e-7 m, 1e-6 rad, 1e-6 s) and "gold" (4e-10 m, 1e-8 rad, 1e-8 s),
/// both with the same events as the truth, and 1e-13 to judge them by.
[[nodiscard]] std::vector<Setting> reference_settings();

/// 90 Hz and four sub-steps, then frame and sub-step shortened together, each time to a half.
[[nodiscard]] std::vector<Setting> realtime_settings();

struct ConvergenceRun {
  Setting setting{};
  Recording recording{};
  long steps{};       ///< accepted by an integrator; sub-steps of a stepped engine
  double cost{};      ///< CPU seconds a simulated second
  Gap to_tightest{};  ///< difference to the last run; zero for that
  Gap error{};        ///< estimate: that difference, plus what the last run itself is thought to err
  bool kept{true};    ///< no promise, or kept; a run that did not get to its end keeps none
};

struct SelfConvergence {
  std::vector<ConvergenceRun> runs{};
  Order position{}, rotation{}, event_time{};  ///< slope of the differences over `size`; NaN if they do not show one
};

/// Told before and during every run; returning false stops.
using ConvergenceProgress = std::function<bool(const Setting& setting, double t)>;

/// Runs `engine` at `settings`, the tightest last, and compares all with that. The error of the last is estimated by
/// continuing the slope of the others to its size. Self-convergence does not show an error that all runs share: a
/// closed form or an independent solver does.
[[nodiscard]] SelfConvergence self_convergence(const Engine& engine, const Scene& scene,
                                               const std::vector<Setting>& settings,
                                               const ConvergenceProgress& progress = {});

}  // namespace handhold::compare
