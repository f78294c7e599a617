// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/engine/engine.hpp"
#include "compare/judge/result.hpp"

namespace handhold::compare {

struct SuiteOptions {
  EngineOptions engine{};
  std::vector<std::string> ids{};                   ///< cases to run; empty: all
  std::vector<Level> levels{};                      ///< empty: all
  std::vector<int> study_refinements{2, 4, 8, 16};  ///< of frame and step in the order studies; empty: none
  bool variants{true};                              ///< also runs that are turned, mirrored, reordered
  std::optional<Shard> shard{};                     ///< the part to play; none: all
  int threads{0};                                   ///< that work side by side; 0: one a core
  bool keep_recordings{false};                      ///< for the page's replay
  bool fail_fast{false};                            ///< stop at the first gate that fails
  std::function<bool()> stop{};  ///< asked now and then within a run; true ends the suite, without that run
};

/// Told what is about to run, how many runs are done and how many there are; returning false stops before it. Called by
/// one thread at a time.
using SuiteProgress = std::function<bool(const std::string& what, std::size_t done, std::size_t all)>;

/// Plays every run of every case with every engine that can, and judges. What is measured does not depend on the number
/// of threads. Throws InputError for an unknown id (listing the ids), or when no engine is given.
[[nodiscard]] SuiteResult run_suite(const std::vector<const Engine*>& engines, const SuiteOptions& options = {},
                                    const SuiteProgress& progress = {});

}  // namespace handhold::compare
