#include "reports/data/table.hpp"

#include <algorithm>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "reports/data/placed_gate.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

constexpr std::size_t table_width = 140;

std::string paint(std::string_view text, std::string_view code, const TableStyle& style) {
  return style.colour ? fmt::format("\x1b[{}m{}\x1b[0m", code, text) : std::string(text);
}

std::string paint(std::string_view text, Verdict v, const TableStyle& style) {
  return paint(text, v == Verdict::fail ? "1;31" : v == Verdict::vacuous ? "33" : "32", style);
}

std::string rule(char c) { return std::string(table_width, c).append("\n"); }

std::string row(std::string_view quantity, std::string_view truth, std::string_view reference,
                std::string_view realtime, std::string_view reference_error, std::string_view reference_limit,
                std::string_view realtime_error, std::string_view realtime_limit, std::string_view order,
                std::string_view pedigree) {
  return left(quantity, 28) + right(truth, 12) + right(reference, 12) + right(realtime, 12) +
         right(reference_error, 10) + right(reference_limit, 9) + right(realtime_error, 10) + right(realtime_limit, 9) +
         right(order, 13) + "  " + left(pedigree, 15);
}

std::string header() {
  return row("quantity", "truth", "reference", "real time", "ref.error", "limit", "rt.error", "limit", "order",
             "pedigree") +
         "verdict\n";
}

std::string value_text(const compare::Judgement& judgement) {
  return judgement.asked ? number(judgement.value) : "not asked";
}

std::string limit_text(const compare::Judgement& judgement, const catalogue::Limit& limit) {
  return judgement.asked ? error_number(judgement.gate.limit, limit.relative) : "";
}

std::string error_text(const compare::Judgement& judgement, const catalogue::Limit& limit) {
  if (!judgement.asked) return "";
  return error_number(judgement.error, limit.relative);
}

/// The worst of the finding's gates.
Verdict verdict_of(const compare::Finding& finding) {
  Verdict worst = std::max(verdict(finding.reference.gate), verdict(finding.realtime.gate));
  if (finding.study) worst = std::max(worst, verdict(finding.study->gate));
  return worst;
}

std::string order_text(const compare::Finding& finding) {
  if (!finding.study) return "";
  std::string text = with_error(finding.study->order.slope, finding.study->order.standard_error);
  std::erase(text, ' ');
  return text;
}

/// Holding is what matters in a row; that a gate of it guards nothing is a mark.
std::string mark(Verdict v) { return v == Verdict::vacuous ? "pass (v)" : std::string(to_string(v)); }

std::string finding_row(const compare::Finding& finding, const TableStyle& style) {
  const catalogue::Expectation& e = finding.expectation;
  const std::string quantity = one_line(e.unit.empty() ? e.quantity : fmt::format("{} [{}]", e.quantity, e.unit));
  const Verdict v = verdict_of(finding);
  return row("  " + quantity, number(e.truth), number(finding.reference.value), value_text(finding.realtime),
             error_text(finding.reference, e.reference),
             error_number(finding.reference.gate.limit, e.reference.relative), error_text(finding.realtime, e.realtime),
             limit_text(finding.realtime, e.realtime), order_text(finding), catalogue::to_string(e.pedigree)) +
         paint(mark(v), v, style) + "\n";
}

std::string run_rows(const compare::RunResult& run, const TableStyle& style) {
  std::string out = " " + one_line(run.name) + "\n";
  for (const compare::Finding& finding : run.findings) out += finding_row(finding, style);
  if (!run.reference_note.empty()) out += "  the reference ended early: " + one_line(run.reference_note) + "\n";
  if (!run.realtime_note.empty()) out += "  the real-time path " + one_line(realtime_fate(run)) + "\n";
  return out;
}

std::string case_rows(const compare::CaseResult& of_case, const TableStyle& style) {
  std::string out =
      paint(one_line(of_case.id + "  " + of_case.title), "1", style) + "  (" + one_line(of_case.level) + ")\n";
  for (const compare::RunResult& run : of_case.runs) out += run_rows(run, style);
  return out;
}

std::string in_words(const PlacedGate& placed) {
  return fmt::format("  {}: {}\n", one_line(place(placed)), one_line(compare::sentence(*placed.gate)));
}

std::string failures(const std::vector<PlacedGate>& gates, const TableStyle& style) {
  std::string out;
  for (const PlacedGate& placed : gates) {
    if (verdict(*placed.gate) != Verdict::fail) continue;
    out += in_words(placed) + fmt::format("      limit because: {}\n", one_line(placed.gate->reason));
    out += fmt::format("      truth: {}\n", one_line(placed.finding->expectation.source));
  }
  return out.empty() ? "" : "\n" + paint("Failed gates", Verdict::fail, style) + "\n" + out;
}

/// Grouped by the reason of their limits, which is what has to be thought over.
std::string vacuous(const std::vector<PlacedGate>& gates, const TableStyle& style) {
  std::map<std::string, std::string> by_reason;
  for (const PlacedGate& placed : gates) {
    if (verdict(*placed.gate) == Verdict::vacuous) by_reason[one_line(placed.gate->reason)] += in_words(placed);
  }
  if (by_reason.empty()) return "";
  std::string out = "\n" +
                    paint("Vacuous gates, marked (v): they could be 100 times tighter, and so guard nothing",
                          Verdict::vacuous, style) +
                    "\n";
  for (const auto& [reason, lines] : by_reason) out += lines + "      limits because: " + reason + "\n";
  return out;
}

std::string frame_rows(const compare::SuiteResult& result) {
  std::string out;
  for (const compare::CaseResult& of_case : result.cases) {
    for (const compare::RunResult& run : of_case.runs) {
      const compare::FrameTimes& f = run.realtime_frame;
      if (f.frames == 0) continue;
      out += "  " + left(one_line(of_case.id + "/" + run.name), 40) + right(std::to_string(f.frames), 8);
      for (const double seconds : {f.p50, f.p90, f.p99, f.p999, f.max}) out += right(number(seconds * 1e6, 3), 10);
      out += right(number(run.realtime_seconds, 3), 12) + right(number(run.reference_seconds, 3), 12) + "\n";
    }
  }
  if (out.empty()) return "";
  std::string head = "\nCPU time a frame of the real-time path [µs], wall time of the whole run [s]\n  " +
                     left("case/run", 40) + right("frames", 8);
  for (const char* name : {"p50", "p90", "p99", "p99.9", "max"}) head += right(name, 10);
  return head + right("real time", 12) + right("reference", 12) + "\n" + out;
}

}  // namespace

std::string text_table(const compare::SuiteResult& result, const TableStyle& style) {
  const std::vector<PlacedGate> gates = placed_gates(result);
  std::string out = rule('=') + header() + rule('-');
  for (const compare::CaseResult& of_case : result.cases) out += case_rows(of_case, style);
  out += rule('=');
  out += vacuous(gates, style);
  out += frame_rows(result);
  out += failures(gates, style);
  out += fmt::format("\ntotal time {} s\n", number(result.seconds, 3));
  out +=
      paint(one_line(verdict_sentence(result)), compare::passed(result) ? Verdict::pass : Verdict::fail, style) + "\n";
  return out;
}

}  // namespace handhold::reports
