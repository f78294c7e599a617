#include "reports/data/placed_gate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

void append(std::vector<PlacedGate>& out, const compare::CaseResult& of_case, const compare::RunResult& run) {
  for (const compare::Finding& finding : run.findings) {
    out.push_back({&of_case, &run, &finding, Judged::reference, &finding.reference.gate});
    if (finding.realtime.asked) out.push_back({&of_case, &run, &finding, Judged::realtime, &finding.realtime.gate});
    if (finding.study) out.push_back({&of_case, &run, &finding, Judged::order, &finding.study->gate});
  }
}

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

Verdict verdict(const compare::Gate& gate) {
  if (!compare::passes(gate)) return Verdict::fail;
  return compare::is_vacuous(gate) ? Verdict::vacuous : Verdict::pass;
}

double slack(const compare::Gate& gate) {
  if (std::isnan(gate.measured) || std::isnan(gate.limit)) return std::numeric_limits<double>::quiet_NaN();
  const bool at_most = gate.bound == compare::Bound::at_most;
  const double allowed = at_most ? gate.limit : gate.measured;
  const double used = at_most ? gate.measured : gate.limit;
  if (used == 0) return allowed >= 0 ? std::numeric_limits<double>::infinity() : 0;
  return allowed / used;
}

std::vector<PlacedGate> placed_gates(const compare::SuiteResult& result) {
  std::vector<PlacedGate> out;
  for (const compare::CaseResult& of_case : result.cases) {
    for (const compare::RunResult& run : of_case.runs) append(out, of_case, run);
  }
  return out;
}

std::vector<PlacedGate> placed_gates(const compare::CaseResult& of_case, const compare::RunResult& run) {
  std::vector<PlacedGate> out;
  append(out, of_case, run);
  return out;
}

std::string place(const PlacedGate& gate) { return fmt::format("{}/{}", gate.of_case->id, gate.run->name); }

bool was_asked(const compare::RunResult& run) {
  return std::all_of(run.findings.begin(), run.findings.end(), [](const auto& f) { return f.realtime.asked; });
}

std::string realtime_fate(const compare::RunResult& run) {
  return was_asked(run) ? "ended early: " + run.realtime_note : "was " + run.realtime_note;
}

Count count(const std::vector<PlacedGate>& gates) {
  Count out{gates.size(), 0, 0};
  for (const PlacedGate& placed : gates) {
    const Verdict v = verdict(*placed.gate);
    out.failed += v == Verdict::fail;
    out.vacuous += v == Verdict::vacuous;
  }
  return out;
}

std::string headline(const compare::SuiteResult& result) {
  const Count n = count(placed_gates(result));
  if (n.gates == 0) return result.interrupted ? "Interrupted before any gate was judged" : "Failed: no gate was judged";
  if (result.interrupted) return fmt::format("Interrupted: {} of {} failed so far", n.failed, plural(n.gates, "gate"));
  if (n.failed > 0) return fmt::format("Failed: {} of {}", n.failed, plural(n.gates, "gate"));
  return fmt::format("Passed: {}", plural(n.gates, "gate"));
}

std::string verdict_sentence(const compare::SuiteResult& result) {
  const std::vector<PlacedGate> gates = placed_gates(result);
  const Count n = count(gates);
  const std::string asked = fmt::format("{} of {}", plural(n.gates, "gate"), plural(result.cases.size(), "case"));
  const std::string vacuous = n.vacuous > 0
                                  ? fmt::format("; {} of them could be 100 times tighter and {} flagged as vacuous",
                                                n.vacuous, n.vacuous == 1 ? "is" : "are")
                                  : "";
  if (n.gates == 0)
    return result.interrupted ? "Interrupted before any gate was judged."
                              : "Failed: no gate was judged, and nothing judged is no pass.";
  const auto first =
      std::find_if(gates.begin(), gates.end(), [](const PlacedGate& g) { return verdict(*g.gate) == Verdict::fail; });
  const std::string failure =
      first == gates.end() ? "" : fmt::format("; first: {} ({})", compare::sentence(*first->gate), place(*first));
  if (result.interrupted) {
    return fmt::format("Interrupted, so this is no pass: of the {} judged until then, {} failed{}.", asked, n.failed,
                       failure);
  }
  if (n.failed > 0) return fmt::format("Failed: {} of the {} did not hold{}.", n.failed, asked, failure);
  return fmt::format("Passed: all {} hold{}.", asked, vacuous);
}

}  // namespace handhold::reports
