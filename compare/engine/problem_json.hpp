// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "compare/engine/sampled_problem.hpp"

// problem.json, the file that a foreign process is given: compare/engine/problem.schema.json and docs/engines.md.

namespace handhold::compare {

/// Numbers have as many digits as it takes to read the same bits back. Throws InputError for a number that is not
/// finite: JSON has none.
[[nodiscard]] std::string problem_json(const SampledProblem& problem);

/// Reads it back, the same to the last bit. Throws InputError naming `path` for what is no problem of this format, a
/// missing member, a value of the wrong kind, or lists of samples of another length than steps + 1.
[[nodiscard]] SampledProblem read_problem_json(std::string_view text, const std::string& path);

}  // namespace handhold::compare
