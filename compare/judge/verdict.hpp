// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "compare/judge/result.hpp"

namespace handhold::compare {

enum class Verdict { pass, vacuous, fail };

/// What to write beside a gate, in words.
[[nodiscard]] std::string_view to_string(Verdict verdict);

[[nodiscard]] Verdict verdict(const Gate& gate);

/// How many times tighter the gate could be and still hold: limit / measured, or measured / limit for `at_least`. Below
/// 1 it fails; infinite for an exact answer; NaN when a number is.
[[nodiscard]] double slack(const Gate& gate);

/// A gate and where it stands; all pointers into the SuiteResult.
struct PlacedGate {
  const CaseResult* of_case{};
  const RunResult* run{};
  const ClaimResult* claim{};
  std::string engine{};
  const Gate* gate{};
};

/// Claim by claim: every engine's judgement, then the order studies.
[[nodiscard]] std::vector<PlacedGate> placed_gates(const SuiteResult& result);

/// "D02/fast": where the gate stands; its quantity says which engine.
[[nodiscard]] std::string place(const CaseResult& of_case, const RunResult& run);

struct Count {
  std::size_t gates{}, failed{}, vacuous{};
  std::size_t not_asked{}, graded{};  ///< judgements without a gate
};

[[nodiscard]] Count count(const SuiteResult& result);

/// What a verdict follows from, also of results that were stored.
struct Standing {
  Count count{};
  std::size_t cases{};
  bool interrupted{};
  std::string first_failure{};  ///< the first failed gate in words, and its place; empty: none failed
};

[[nodiscard]] Standing standing(const SuiteResult& result);

/// True when every gate holds, there is at least one, and the run was not interrupted.
[[nodiscard]] bool passed(const Standing& standing);
[[nodiscard]] bool passed(const SuiteResult& result);

/// The verdict in few words, for a title: "Failed: 3 of 84 gates".
[[nodiscard]] std::string headline(const SuiteResult& result);

/// The verdict in one sentence, with the first failed gate in words.
[[nodiscard]] std::string verdict_sentence(const Standing& standing);
[[nodiscard]] std::string verdict_sentence(const SuiteResult& result);

}  // namespace handhold::compare
