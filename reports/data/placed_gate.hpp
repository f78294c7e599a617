#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "compare/judge/suite.hpp"

namespace handhold::reports {

enum class Judged { reference, realtime, order };

enum class Verdict { pass, vacuous, fail };

/// What to write beside a gate, in words.
[[nodiscard]] std::string_view to_string(Verdict verdict);

/// A gate and where it stands; all pointers into the SuiteResult.
struct PlacedGate {
  const compare::CaseResult* of_case{};
  const compare::RunResult* run{};
  const compare::Finding* finding{};
  Judged judged{};
  const compare::Gate* gate{};
};

[[nodiscard]] Verdict verdict(const compare::Gate& gate);

/// How many times tighter the gate could be and still hold: limit / measured, or measured / limit for `at_least`. Below
/// 1 it fails; infinite for an exact answer; NaN when a number is.
[[nodiscard]] double slack(const compare::Gate& gate);

/// In the order of `compare::gates`.
[[nodiscard]] std::vector<PlacedGate> placed_gates(const compare::SuiteResult& result);

/// The gates of one run, in the same order.
[[nodiscard]] std::vector<PlacedGate> placed_gates(const compare::CaseResult& of_case, const compare::RunResult& run);

/// "D02/fast": where the gate stands; its quantity says which engine.
[[nodiscard]] std::string place(const PlacedGate& gate);

struct Count {
  std::size_t gates{}, failed{}, vacuous{};
};

[[nodiscard]] Count count(const std::vector<PlacedGate>& gates);

/// Whether the real-time path was asked to play the run (Run::not_realtime).
[[nodiscard]] bool was_asked(const compare::RunResult& run);

/// What became of the real-time path in a run that has a note on it: "ended early: ..." or "was not asked: ...".
[[nodiscard]] std::string realtime_fate(const compare::RunResult& run);

/// The verdict in few words, for a title: "Failed: 3 of 84 gates".
[[nodiscard]] std::string headline(const compare::SuiteResult& result);

/// The verdict in one sentence, with the first failed gate in words.
[[nodiscard]] std::string verdict_sentence(const compare::SuiteResult& result);

}  // namespace handhold::reports
