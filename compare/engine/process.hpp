// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cases/model/recording.hpp"
#include "compare/engine/sampled_problem.hpp"

// Anybody's engine as a process: it reads problem.json, steps, and writes frames.csv (docs/engines.md).

namespace handhold::compare {

struct ProcessOptions {
  std::string command{};           ///< for /bin/sh, e.g. "python3 mine.py {problem} {out}"
  double time_limit{60};           ///< then it is killed, with all it started [s], > 0
  std::filesystem::path folder{};  ///< for {problem} and {out}, which stay there; empty: temporary
};

/// Throws InputError for a command without {problem} and {out}, and for a time limit that is not > 0.
void validate(const ProcessOptions& options);

/// What came of it: one of the three.
struct ProcessAnswer {
  std::optional<Recording> recording{};
  std::string not_asked{};  ///< why the engine cannot express this problem
  std::string fault{};      ///< what went wrong, as a sentence that starts with the command
  std::string output{};     ///< the end of what it printed
};

/// Throws InputError for a command without {problem} and {out}, a time limit that is not > 0, and where no folder can
/// be made. Everything that the process does wrong is data.
[[nodiscard]] ProcessAnswer play_in_process(const SampledProblem& problem, const ProcessOptions& options);

/// What is wrong with a recording as an answer to the problem, as a sentence; empty: nothing. It must have the
/// problem's name (or none), its bodies, and all its frames at their times, finite, with unit quaternions.
[[nodiscard]] std::string answer_fault(const Recording& answer, const SampledProblem& problem);

}  // namespace handhold::compare
