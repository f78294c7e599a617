// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/junit.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "compare/judge/verdict.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

double finite(double seconds) { return std::isfinite(seconds) ? seconds : 0; }

struct Tally {
  std::string lines{};
  std::size_t tests{}, failed{}, skipped{};
};

std::string name_of(const compare::CaseResult& of_case, const compare::RunResult& run) {
  return escape("handhold." + of_case.id + "." + run.name + (run.variant.empty() ? "" : ", ") + run.variant);
}

void add(Tally& tally, const std::string& where, const std::string& name, const std::string& inside) {
  tally.lines += fmt::format("    <testcase classname=\"{}\" name=\"{}\"", where, escape(name));
  tally.lines += inside.empty() ? "/>\n" : ">\n" + inside + "    </testcase>\n";
  ++tally.tests;
}

void add_gate(Tally& tally, const std::string& where, const compare::Gate& gate, const catalogue::Claim& claim) {
  std::string inside;
  if (!compare::passes(gate)) {
    ++tally.failed;
    const std::string text =
        fmt::format("{}\nlimit because: {}\ntruth ({}): {} {}, {}\n", compare::sentence(gate), gate.reason,
                    catalogue::to_string(gate.pedigree), number(claim.truth, 17), claim.unit, claim.source);
    inside = fmt::format("      <failure type=\"gate\" message=\"{}\">{}</failure>\n", escape(compare::sentence(gate)),
                         escape(text));
  }
  add(tally, where, gate.quantity, inside);
}

/// Judgements without a gate count as skipped: what nobody asked, and grades, which fail nothing.
void add_judgement(Tally& tally, const std::string& where, const compare::Judgement& j, const catalogue::Claim& claim) {
  if (j.gate) return add_gate(tally, where, *j.gate, claim);
  ++tally.skipped;
  const std::string why = j.grade ? fmt::format("graded: {}", compare::to_string(*j.grade)) : "not asked: " + j.why_not;
  add(tally, where, fmt::format("{}, {}", claim.quantity, j.engine),
      fmt::format("      <skipped message=\"{}\"/>\n", escape(why)));
}

std::string testsuite(const compare::CaseResult& of_case, Tally& all) {
  Tally tally;
  for (const compare::RunResult& run : of_case.runs) {
    const std::string where = name_of(of_case, run);
    for (const compare::ClaimResult& claim : run.claims) {
      for (const compare::Judgement& j : claim.judgements) add_judgement(tally, where, j, claim.claim);
      for (const compare::OrderStudy& study : claim.studies) add_gate(tally, where, study.gate, claim.claim);
    }
  }
  all.tests += tally.tests;
  all.failed += tally.failed;
  all.skipped += tally.skipped;
  return fmt::format(
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\">\n{}  </testsuite>\n",
      escape(of_case.id + " " + of_case.title), tally.tests, tally.failed, tally.skipped, tally.lines);
}

/// A test for each gate that moved since the baseline, all failed; one that passes where nothing moved.
std::string baseline_suite(const std::vector<compare::Change>& moved, Tally& all) {
  Tally tally;
  for (const compare::Change& change : moved) {
    const std::string text = escape(compare::sentence(change));
    add(tally, "handhold.baseline", compare::sentence(change),
        fmt::format("      <failure type=\"baseline\" message=\"{}\"/>\n", text));
  }
  if (moved.empty()) add(tally, "handhold.baseline", "nothing moved", "");
  all.tests += tally.tests;
  all.failed += moved.size();
  return fmt::format(
      "  <testsuite name=\"baseline\" tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\">\n{}  </testsuite>\n",
      tally.tests, moved.size(), tally.lines);
}

/// What makes the whole run no pass although its gates may hold.
std::string run_error(const compare::SuiteResult& result) {
  return fmt::format(
      "  <testsuite name=\"the run itself\" tests=\"1\" failures=\"0\" errors=\"1\" skipped=\"0\" time=\"0\">\n"
      "    <testcase classname=\"handhold\" name=\"complete\" time=\"0\"><error type=\"incomplete\" "
      "message=\"{}\"/></testcase>\n"
      "  </testsuite>\n",
      escape(compare::verdict_sentence(result)));
}

}  // namespace

std::string junit_xml(const compare::SuiteResult& result) {
  const bool incomplete = result.interrupted || compare::count(result).gates == 0;
  std::string suites;
  Tally all;
  for (const compare::CaseResult& of_case : result.cases) suites += testsuite(of_case, all);
  if (result.moved) suites += baseline_suite(*result.moved, all);
  if (incomplete) suites += run_error(result);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites name=\"handhold\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" "
      "time=\"{:.6f}\">\n{}</testsuites>\n",
      all.tests + incomplete, all.failed, incomplete ? 1 : 0, all.skipped, finite(result.seconds), suites);
}

}  // namespace handhold::reports
