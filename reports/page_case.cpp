#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/data/text.hpp"
#include "reports/page_parts.hpp"

namespace handhold::reports {
namespace {

/// "3.1×10⁻⁸ ≤ 1×10⁻⁶", or with the opposite sign, in words and bold, when the gate failed.
std::string against_limit(const compare::Judgement& judgement, bool relative) {
  const compare::Gate& gate = judgement.gate;
  const bool holds = compare::passes(gate), at_most = gate.bound == compare::Bound::at_most;
  const std::string limit = html_error(gate.limit, relative);
  if (std::isnan(gate.measured)) return fmt::format("<span class=\"bad\">✗ none</span>, limit {}", limit);
  const std::string error = html_error(gate.measured, relative);
  if (holds) return fmt::format("{} {} {}", error, at_most ? "≤" : "≥", limit);
  return fmt::format("<span class=\"bad\">✗ {} {} {}</span>", error, at_most ? "&gt;" : "&lt;", limit);
}

std::string order_cell(const compare::Finding& finding) {
  if (!finding.study) return "–";
  const compare::Order& order = finding.study->order;
  const std::string text = escape(typographic(with_error(order.slope, order.standard_error)));
  return compare::passes(finding.study->gate) ? text : "<span class=\"bad\">✗ " + text + "</span>";
}

/// Holding is what matters in a row; the section on gates says which ones guard nothing.
Verdict worst(const compare::Finding& finding) {
  Verdict out = std::max(verdict(finding.reference.gate), verdict(finding.realtime.gate));
  return finding.study ? std::max(out, verdict(finding.study->gate)) : out;
}

std::string finding_row(const compare::Finding& finding) {
  const catalogue::Expectation& e = finding.expectation;
  const std::string quantity = e.unit.empty() ? e.quantity : fmt::format("{} [{}]", e.quantity, e.unit);
  return fmt::format(
      "<tr><th scope=\"row\" class=\"quantity\">{}<span class=\"source\">{}: {}</span></th><td class=\"n\">{}</td><td "
      "class=\"n\">{}</td><td class=\"n\">{}</td>"
      "<td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td>{}</td></tr>\n",
      escape(quantity), escape(catalogue::to_string(e.pedigree)), escape(e.source), html_number(e.truth),
      html_number(finding.reference.value), against_limit(finding.reference, e.reference.relative),
      finding.realtime.asked ? html_number(finding.realtime.value) : "not asked",
      finding.realtime.asked ? against_limit(finding.realtime, e.realtime.relative) : "", order_cell(finding),
      verdict_tag(worst(finding) == Verdict::fail ? Verdict::fail : Verdict::pass));
}

std::string findings_table(const compare::RunResult& run) {
  if (run.findings.empty()) return "";
  std::string rows;
  for (const compare::Finding& finding : run.findings) rows += finding_row(finding);
  return fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Quantities of {0}\"><table><caption>Errors "
      "are |value − truth| in the quantity’s unit, or a fraction of the "
      "truth where they carry a %</caption><thead><tr><th scope=\"col\">Quantity and where its truth comes "
      "from</th><th scope=\"col\" class=\"n\">Truth</th><th scope=\"col\" class=\"n\">"
      "Reference</th><th scope=\"col\" class=\"n\">its error</th><th scope=\"col\" class=\"n\">Real time</th><th "
      "scope=\"col\" class=\"n\">its error</th>"
      "<th scope=\"col\" class=\"n\">Order</th><th "
      "scope=\"col\">Verdict</th></tr></thead><tbody>\n{1}</tbody></table></div>\n",
      escape(run.name), rows);
}

std::string notes(const compare::RunResult& run) {
  std::string out;
  if (!run.reference_note.empty())
    out += fmt::format("<p class=\"bad\">The reference ended early: {}</p>\n", escape(run.reference_note));
  if (!run.realtime_note.empty())
    out += fmt::format("<p{}>The real-time path {}</p>\n", was_asked(run) ? " class=\"bad\"" : "",
                       escape(realtime_fate(run)));
  return out;
}

std::string times(const compare::RunResult& run) {
  std::string out =
      fmt::format("Wall time: reference {}, real time {}.", escape(readable(run.reference_seconds, "s", 3)),
                  escape(readable(run.realtime_seconds, "s", 3)));
  const compare::FrameTimes& f = run.realtime_frame;
  if (f.frames > 0) {
    out += fmt::format(" CPU time of a real-time frame: median {}, p99 {}, p99.9 {}, slowest of {} frames {}.",
                       escape(readable(f.p50, "s", 3)), escape(readable(f.p99, "s", 3)),
                       escape(readable(f.p999, "s", 3)), f.frames, escape(readable(f.max, "s", 3)));
  }
  return "<p class=\"quiet\">" + out + "</p>\n";
}

std::string run_html(const compare::RunResult& run, const std::string& id) {
  std::string figures = curve_figure(run, id + "-curve");
  for (std::size_t i = 0; i < run.findings.size(); ++i)
    figures += order_figure(run.findings[i], fmt::format("{}-order{}", id, i));
  std::string out = fmt::format("<h3>{}</h3>\n", escape(run.name)) + notes(run) + findings_table(run);
  if (!figures.empty()) out += "<div class=\"figures\">" + figures + "</div>\n";
  return out + times(run);
}

}  // namespace

std::string case_section(const compare::CaseResult& of_case, std::size_t index) {
  const std::string id = escape("case-" + of_case.id);
  std::string out =
      fmt::format("<section id=\"{0}\" aria-labelledby=\"{0}-title\"><h2 id=\"{0}-title\">{1} · {2}</h2>\n", id,
                  escape(of_case.id), escape(of_case.title));
  if (!of_case.statement.empty()) out += fmt::format("<p>{}</p>\n", escape(of_case.statement));
  if (!of_case.formula.empty()) out += fmt::format("<pre><code>{}</code></pre>\n", escape(of_case.formula));
  if (!of_case.level.empty())
    out += fmt::format("<p class=\"quiet\">Truth at level {}. {}</p>\n", escape(of_case.level), escape(of_case.note));
  for (std::size_t i = 0; i < of_case.runs.size(); ++i)
    out += run_html(of_case.runs[i], fmt::format("figure-{}-{}", index, i));
  return out + "</section>\n";
}

}  // namespace handhold::reports
