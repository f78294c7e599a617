#include "reports/data/junit.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/data/placed_gate.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

double finite(double seconds) { return std::isfinite(seconds) ? seconds : 0; }

double seconds_of(const PlacedGate& placed) {
  const double gates = static_cast<double>(placed.run->findings.size());
  switch (placed.judged) {
    case Judged::reference:
      return finite(placed.run->reference_seconds) / gates;
    case Judged::realtime:
      return finite(placed.run->realtime_seconds) / gates;
    case Judged::order:
      return 0;
  }
  return 0;
}

std::string failure(const PlacedGate& placed) {
  const catalogue::Expectation& e = placed.finding->expectation;
  const std::string text = fmt::format(
      "{}\nlimit because: {}\ntruth ({}): {} {}, {}\n", compare::sentence(*placed.gate), placed.gate->reason,
      catalogue::to_string(placed.gate->pedigree), number(e.truth, 17), e.unit, e.source);
  return fmt::format("      <failure type=\"gate\" message=\"{}\">{}</failure>\n",
                     escape(compare::sentence(*placed.gate)), escape(text));
}

std::string testcase(const PlacedGate& placed) {
  const std::string open = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.6f}\"",
                                       escape("handhold." + placed.of_case->id + "." + placed.run->name),
                                       escape(placed.gate->quantity), seconds_of(placed));
  if (verdict(*placed.gate) != Verdict::fail) return open + "/>\n";
  return open + ">\n" + failure(placed) + "    </testcase>\n";
}

std::string testsuite(const compare::CaseResult& of_case) {
  std::string cases;
  std::size_t tests = 0, failed = 0;
  double seconds = 0;
  for (const compare::RunResult& run : of_case.runs) {
    for (const PlacedGate& placed : placed_gates(of_case, run)) {
      cases += testcase(placed);
      failed += verdict(*placed.gate) == Verdict::fail;
      seconds += seconds_of(placed);
      ++tests;
    }
  }
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\" time=\"{:.6f}\">\n{}  "
      "</testsuite>\n",
      escape(of_case.id + " " + of_case.title), tests, failed, seconds, cases);
}

/// What makes the whole run no pass although its gates may hold.
std::string run_error(const compare::SuiteResult& result) {
  return fmt::format(
      "  <testsuite name=\"the run itself\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\" time=\"0\">\n"
      "    <testcase classname=\"handhold\" name=\"complete\" time=\"0\"><error type=\"incomplete\" "
      "message=\"{}\"/></testcase>\n"
      "  </testsuite>\n",
      escape(verdict_sentence(result)));
}

}  // namespace

std::string junit_xml(const compare::SuiteResult& result) {
  const Count n = count(placed_gates(result));
  const bool incomplete = result.interrupted || n.gates == 0;
  std::string suites;
  for (const compare::CaseResult& of_case : result.cases) suites += testsuite(of_case);
  if (incomplete) suites += run_error(result);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"handhold\" tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.6f}\">\n{}</testsuites>\n",
      n.gates + incomplete, n.failed, incomplete ? 1 : 0, finite(result.seconds), suites);
}

}  // namespace handhold::reports
