// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/verdict.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace handhold::compare {
namespace {

std::string plural(std::size_t count, std::string_view word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

}  // namespace

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::vacuous:
      return "vacuous";
    case Verdict::fail:
      return "FAIL";
  }
  return "";
}

Verdict verdict(const Gate& gate) {
  if (!passes(gate)) return Verdict::fail;
  return is_vacuous(gate) ? Verdict::vacuous : Verdict::pass;
}

double slack(const Gate& gate) {
  if (std::isnan(gate.measured) || std::isnan(gate.limit)) return std::numeric_limits<double>::quiet_NaN();
  const bool at_most = gate.bound == Bound::at_most;
  const double allowed = at_most ? gate.limit : gate.measured;
  const double used = at_most ? gate.measured : gate.limit;
  if (used == 0) return allowed >= 0 ? std::numeric_limits<double>::infinity() : 0;
  return allowed / used;
}

std::vector<PlacedGate> placed_gates(const SuiteResult& result) {
  std::vector<PlacedGate> out;
  for (const CaseResult& of_case : result.cases) {
    for (const RunResult& run : of_case.runs) {
      for (const ClaimResult& claim : run.claims) {
        for (const Judgement& j : claim.judgements)
          if (j.gate) out.push_back({&of_case, &run, &claim, j.engine, &*j.gate});
        for (const OrderStudy& s : claim.studies) out.push_back({&of_case, &run, &claim, s.engine, &s.gate});
      }
    }
  }
  return out;
}

std::string place(const CaseResult& of_case, const RunResult& run) {
  return fmt::format("{}/{}{}{}", of_case.id, run.name, run.variant.empty() ? "" : ", ", run.variant);
}

Count count(const SuiteResult& result) {
  Count out;
  for (const PlacedGate& placed : placed_gates(result)) {
    const Verdict v = verdict(*placed.gate);
    ++out.gates;
    out.failed += v == Verdict::fail;
    out.vacuous += v == Verdict::vacuous;
  }
  for (const CaseResult& of_case : result.cases)
    for (const RunResult& run : of_case.runs)
      for (const ClaimResult& claim : run.claims)
        for (const Judgement& j : claim.judgements) {
          out.not_asked += !j.why_not.empty();
          out.graded += j.grade.has_value();
        }
  return out;
}

Standing standing(const SuiteResult& result) {
  Standing out{count(result), result.cases.size(), result.interrupted, ""};
  for (const PlacedGate& g : placed_gates(result)) {
    if (verdict(*g.gate) != Verdict::fail) continue;
    out.first_failure = fmt::format("{} ({})", sentence(*g.gate), place(*g.of_case, *g.run));
    break;
  }
  return out;
}

bool passed(const Standing& s) { return !s.interrupted && s.count.gates > 0 && s.count.failed == 0; }

bool passed(const SuiteResult& result) { return passed(standing(result)); }

std::string headline(const SuiteResult& result) {
  const Count n = count(result);
  if (n.gates == 0) return result.interrupted ? "Interrupted before any gate was judged" : "Failed: no gate was judged";
  if (result.interrupted) return fmt::format("Interrupted: {} of {} failed so far", n.failed, plural(n.gates, "gate"));
  if (n.failed > 0) return fmt::format("Failed: {} of {}", n.failed, plural(n.gates, "gate"));
  return fmt::format("Passed: {}", plural(n.gates, "gate"));
}

std::string verdict_sentence(const Standing& s) {
  const Count& n = s.count;
  const std::string asked = fmt::format("{} of {}", plural(n.gates, "gate"), plural(s.cases, "case"));
  const std::string vacuous = n.vacuous > 0 ? fmt::format("; {} of them {} vacuous (over 100 times what was measured)",
                                                          n.vacuous, n.vacuous == 1 ? "is" : "are")
                                            : "";
  if (n.gates == 0)
    return s.interrupted ? "Interrupted before any gate was judged."
                         : "Failed: no gate was judged, and nothing judged is no pass.";
  const std::string failure = s.first_failure.empty() ? "" : "; first: " + s.first_failure;
  if (s.interrupted) {
    return fmt::format("Interrupted, so this is no pass: of the {} judged until then, {} failed{}.", asked, n.failed,
                       failure);
  }
  if (n.failed > 0) return fmt::format("Failed: {} of the {} did not hold{}.", n.failed, asked, failure);
  return fmt::format("Passed: all {} hold{}.", asked, vacuous);
}

std::string verdict_sentence(const SuiteResult& result) { return verdict_sentence(standing(result)); }

}  // namespace handhold::compare
