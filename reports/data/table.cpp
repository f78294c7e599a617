// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/table.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "compare/judge/verdict.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

using compare::PlacedGate;
using compare::Verdict;

constexpr std::size_t table_width = 140;

std::string paint(std::string_view text, std::string_view code, const TableStyle& style) {
  return style.colour ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
}

std::string_view colour_of(Verdict v) { return v == Verdict::fail ? "1;31" : v == Verdict::vacuous ? "33" : "32"; }

std::string rule(char c) { return std::string(table_width, c).append("\n"); }

std::string row(std::string_view quantity, std::string_view engine, std::string_view value, std::string_view truth,
                std::string_view error, std::string_view limit, std::string_view order, std::string_view verdict) {
  return left(quantity, 40) + left(engine, 17) + right(value, 13) + right(truth, 13) + right(error, 11) +
         right(limit, 10) + right(order, 15) + "  " + std::string(verdict) + "\n";
}

/// Holding is what matters in a row; that a gate of it guards little is a mark.
std::string mark(Verdict v) { return v == Verdict::vacuous ? "pass (v)" : std::string(compare::to_string(v)); }

std::string order_text(const compare::OrderStudy* study) {
  if (!study) return "";
  std::string text = with_error(study->order.slope, study->order.standard_error);
  std::erase(text, ' ');
  return text;
}

const compare::OrderStudy* study_of(const compare::ClaimResult& claim, const std::string& engine) {
  for (const compare::OrderStudy& study : claim.studies)
    if (study.engine == engine) return &study;
  return nullptr;
}

/// The worse of the judgement and its order study, painted.
std::string verdict_text(const compare::Judgement& j, const compare::OrderStudy* study, const TableStyle& style) {
  if (j.grade) return std::string(compare::to_string(*j.grade));
  Verdict v = compare::verdict(*j.gate);
  if (study) v = std::max(v, compare::verdict(study->gate));
  return paint(mark(v), colour_of(v), style);
}

/// One line an engine that was asked; the first carries the claim's name.
std::string claim_rows(const compare::ClaimResult& result, const TableStyle& style) {
  const catalogue::Claim& claim = result.claim;
  std::string quantity =
      "  " + one_line(claim.unit.empty() ? claim.quantity : fmt::format("{} [{}]", claim.quantity, claim.unit));
  std::string out;
  for (const compare::Judgement& j : result.judgements) {
    if (!j.why_not.empty()) continue;
    const compare::OrderStudy* study = study_of(result, j.engine);
    out += row(quantity, j.engine, number(j.value), number(claim.truth), error_number(j.error, j.relative),
               j.gate ? error_number(j.gate->limit, j.relative) : "", order_text(study), verdict_text(j, study, style));
    quantity.clear();
  }
  return out.empty() ? row(quantity, "nobody asked", "", number(claim.truth), "", "", "", "") : out;
}

std::string run_rows(const compare::RunResult& run, const TableStyle& style) {
  std::string out = " " + one_line(run.name) + (run.variant.empty() ? "" : ", " + run.variant) + "\n";
  for (const compare::ClaimResult& claim : run.claims) out += claim_rows(claim, style);
  for (const compare::Play& play : run.plays)
    if (!play.note.empty()) out += fmt::format("  {} ended early: {}\n", play.engine, one_line(play.note));
  return out;
}

std::string case_rows(const compare::CaseResult& of_case, const TableStyle& style) {
  std::string out = paint(one_line(of_case.id + "  " + of_case.title), "1", style) +
                    fmt::format("  (played at {}, truth of {})\n", to_string(of_case.level), of_case.truth_level);
  for (const compare::RunResult& run : of_case.runs) out += run_rows(run, style);
  return out;
}

/// "it does not play L1": 12 claims, realtime. Each reason once.
std::string not_asked(const compare::SuiteResult& result) {
  std::map<std::pair<std::string, std::string>, int> reasons;
  for (const compare::CaseResult& of_case : result.cases)
    for (const compare::RunResult& run : of_case.runs)
      for (const compare::ClaimResult& claim : run.claims)
        for (const compare::Judgement& j : claim.judgements)
          if (!j.why_not.empty()) ++reasons[{j.engine, j.why_not}];
  std::string out;
  for (const auto& [key, count] : reasons)
    out += fmt::format("  {} {}: {}\n", left(key.first, 17), right(std::to_string(count), 5), one_line(key.second));
  return out.empty() ? "" : "\nNot asked (claims, and why)\n" + out;
}

std::string in_words(const PlacedGate& placed) {
  return fmt::format("  {}: {}\n", one_line(compare::place(*placed.of_case, *placed.run)),
                     one_line(compare::sentence(*placed.gate)));
}

std::string failures(const std::vector<PlacedGate>& gates, const TableStyle& style) {
  std::string out;
  for (const PlacedGate& placed : gates) {
    if (compare::verdict(*placed.gate) != Verdict::fail) continue;
    out += in_words(placed) + fmt::format("      limit because: {}\n", one_line(placed.gate->reason));
    out += fmt::format("      truth: {}\n", one_line(placed.claim->claim.source));
  }
  return out.empty() ? "" : "\n" + paint("Failed gates", colour_of(Verdict::fail), style) + "\n" + out;
}

/// By the reason of their limits, which is what has to be thought over; each with how many gates it leaves loose.
std::string vacuous(const std::vector<PlacedGate>& gates, const TableStyle& style) {
  std::map<std::string, int> by_reason;
  for (const PlacedGate& placed : gates)
    if (compare::verdict(*placed.gate) == Verdict::vacuous) ++by_reason[one_line(placed.gate->reason)];
  if (by_reason.empty()) return "";
  std::string out =
      "\n" +
      paint("Vacuous gates, marked (v): limits over 100 times what was measured", colour_of(Verdict::vacuous), style) +
      "\n";
  for (const auto& [reason, count] : by_reason) out += right(std::to_string(count), 6) + "  " + reason + "\n";
  return out;
}

std::string frame_rows(const compare::SuiteResult& result) {
  std::string out;
  for (const compare::CaseResult& of_case : result.cases)
    for (const compare::RunResult& run : of_case.runs)
      for (const compare::Play& play : run.plays) {
        const compare::FrameTimes& f = play.frame;
        if (f.frames == 0 || !run.variant.empty()) continue;
        out += "  " + left(one_line(compare::place(of_case, run)), 40) + left(play.engine, 17) +
               right(std::to_string(f.frames), 8);
        for (const double seconds : {f.p50, f.p90, f.p99, f.p999, f.max}) out += right(number(seconds * 1e6, 3), 10);
        out += "\n";
      }
  if (out.empty()) return "";
  std::string head =
      "\nCPU time a frame [µs], of plain runs\n  " + left("case/run", 40) + left("engine", 17) + right("frames", 8);
  for (const char* name : {"p50", "p90", "p99", "p99.9", "max"}) head += right(name, 10);
  return head + "\n" + out;
}

/// What moved since the baseline, one a line.
std::string moved(const compare::SuiteResult& result, const TableStyle& style) {
  if (!result.moved) return "";
  std::string out;
  for (const compare::Change& change : *result.moved) out += fmt::format("  {}\n", one_line(compare::sentence(change)));
  const std::string title = "Against the baseline: " + compare::summary(*result.moved);
  return "\n" + paint(title, colour_of(out.empty() ? Verdict::pass : Verdict::fail), style) + "\n" + out;
}

}  // namespace

std::string text_table(const compare::SuiteResult& result, const TableStyle& style) {
  const std::vector<PlacedGate> gates = compare::placed_gates(result);
  std::string out =
      rule('=') + row("quantity", "engine", "measured", "truth", "error", "limit", "order", "verdict") + rule('-');
  for (const compare::CaseResult& of_case : result.cases) out += case_rows(of_case, style);
  out += rule('=');
  out += not_asked(result);
  out += vacuous(gates, style);
  out += frame_rows(result);
  out += failures(gates, style);
  out += moved(result, style);
  out += fmt::format("\ntotal time {} s\n", number(result.seconds, 3));
  const Verdict v = compare::passed(result) ? Verdict::pass : Verdict::fail;
  out += paint(one_line(compare::verdict_sentence(result)), colour_of(v), style) + "\n";
  return out;
}

}  // namespace handhold::reports
