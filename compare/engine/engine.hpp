// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "cases/model/problem.hpp"
#include "cases/model/recording.hpp"
#include "compare/judge/error_model.hpp"

namespace handhold::compare {

/// What a user may set of a run. An engine takes what concerns it and says so in EngineInfo::settings.
struct EngineOptions {
  double frame_rate{90};              ///< frames of the recording, and the clock of engines with a fixed step [Hz]
  std::vector<double> frame_times{};  ///< instead of a rate: ascending in (0, duration], the last at its end [s]
  int substeps{4};                    ///< steps a frame, of engines with a fixed step
  int order{1};                       ///< of the real-time path: 1 implicit Euler, 2 implicit midpoint
  double accuracy{1e-10};             ///< of engines that control their error
  double max_step{1e-3};              ///< of engines that control their error [s]
  bool exact_mesh{false};  ///< the reference touches the triangles of smooth bodies, too, not a spline of their voxels
};

/// What a recording of the engine holds beside poses and twists at every frame.
struct Records {
  bool contacts{false};  ///< modes, places and forces of contacts
  bool events{false};    ///< changes of mode, with their instants
  bool energy{false};    ///< the energy ledger
  bool frame_times{false};
};

/// What a reader must know of an engine to read its row.
struct EngineInfo {
  std::string name{};
  std::string version{};
  std::vector<Level> levels{};
  ErrorModel errs{};
  Records records{};
  std::map<std::string, std::string> settings{};  ///< all of them, with units
};

/// Called now and then with the simulated time [s]; returning false stops the run, which keeps what it has.
using Progress = std::function<bool(double t)>;

/// Anything that turns a problem into a recording. An adapter is a few lines (realtime_engine.cpp) and one
/// line in registry.cmake. `play` may be called from several threads at once.
class Engine {
 public:
  virtual ~Engine() = default;

  [[nodiscard]] virtual EngineInfo info(const EngineOptions& options) const = 0;

  /// Why this problem cannot be expressed although its level is played ("one body only"); empty: it can.
  [[nodiscard]] virtual std::string why_not(const Problem&) const { return {}; }

  /// Throws InputError for a problem that is wrong. A run that fails midway is data: see Recording::outcome.
  [[nodiscard]] virtual Recording play(const Problem& problem, const EngineOptions& options,
                                       const Progress& progress = {}) const = 0;
};

}  // namespace handhold::compare
