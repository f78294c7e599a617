#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "reports/data/text.hpp"
#include "reports/page_parts.hpp"

namespace handhold::reports {
namespace {

constexpr std::size_t most_open_rows = 12;

bool is_relative(const PlacedGate& placed) {
  const catalogue::Expectation& e = placed.finding->expectation;
  return placed.judged == Judged::reference ? e.reference.relative
                                            : placed.judged == Judged::realtime && e.realtime.relative;
}

std::string with_unit(const PlacedGate& placed, double value) {
  const compare::Gate& gate = *placed.gate;
  if (is_relative(placed) && gate.unit.empty()) return html_error(value, true);
  return std::isfinite(value) ? escape(readable(value, gate.unit)) : html_number(value);
}

/// The share of the allowance that is used, drawn with the limit at four fifths of the bar; the text beside it says the
/// same.
std::string bar(const compare::Gate& gate, Verdict v) {
  const double room = slack(gate);
  if (std::isnan(room)) return "<span class=\"bad\">no number</span>";
  const double used = room == 0 ? INFINITY : 1 / room;
  const std::string share = !std::isfinite(used) ? "beyond"
                            : used > 10          ? typographic(number(used, 2)) + " times the limit"
                                                 : typographic(number(100 * used, used >= 1 ? 3 : 2)) + " %";
  const char* style = v == Verdict::fail ? "fail" : v == Verdict::vacuous ? "vacuous" : "pass";
  return fmt::format("<span class=\"bar {}\" aria-hidden=\"true\"><i style=\"width:{:.1f}%\"></i><b></b></span>{}",
                     style, std::clamp(80 * used, 0.0, 100.0), share);
}

std::string row(const PlacedGate& placed) {
  const compare::Gate& gate = *placed.gate;
  const Verdict v = verdict(gate);
  return fmt::format(
      "<tr><td>{}</td><th scope=\"row\" class=\"quantity\">{}<span class=\"source\"><a href=\"#{}\">{}</a></span></th>"
      "<td class=\"n\">{}</td><td class=\"n\">{} {}</td><td class=\"use\">{}</td><td>{}</td><td "
      "class=\"wide\">{}</td></tr>\n",
      verdict_tag(v), escape(gate.quantity), escape("case-" + placed.of_case->id), escape(place(placed)),
      with_unit(placed, gate.measured), gate.bound == compare::Bound::at_most ? "≤" : "≥",
      with_unit(placed, gate.limit), bar(gate, v), escape(catalogue::to_string(gate.pedigree)), escape(gate.reason));
}

std::string table(const std::vector<PlacedGate>& gates, Verdict wanted, std::string_view caption) {
  std::string rows;
  for (const PlacedGate& placed : gates) {
    if (verdict(*placed.gate) == wanted) rows += row(placed);
  }
  if (rows.empty()) return "";
  return fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"{0}\"><table><caption>{0}</caption><thead><tr><th scope=\"col\">Verdict</th>"
      "<th scope=\"col\">Quantity</th><th scope=\"col\" class=\"n\">Measured</th><th scope=\"col\" "
      "class=\"n\">Limit</th><th scope=\"col\" class=\"use\">Used of the limit</th>"
      "<th scope=\"col\">Truth is</th><th scope=\"col\">Why this "
      "limit</th></tr></thead><tbody>\n{1}</tbody></table></div>\n",
      escape(caption), rows);
}

/// Open when short, so that what failed stays in sight.
std::string folded(const std::vector<PlacedGate>& gates, Verdict wanted, std::size_t count, std::string_view what) {
  if (count == 0) return "";
  const std::string summary = fmt::format("{} gate{} that {}", count, count == 1 ? "" : "s", what);
  return fmt::format("<details{}><summary>{}</summary>{}</details>\n", count <= most_open_rows ? " open" : "",
                     escape(summary), table(gates, wanted, summary));
}

std::string frame_row(const compare::CaseResult& of_case, const compare::RunResult& run) {
  const compare::FrameTimes& f = run.realtime_frame;
  std::string out = fmt::format("<tr><th scope=\"row\"><a href=\"#{}\">{}</a> {}</th><td class=\"n\">{}</td>",
                                escape("case-" + of_case.id), escape(of_case.id), escape(run.name), f.frames);
  for (const double seconds : {f.p50, f.p90, f.p99, f.p999, f.max})
    out += fmt::format("<td class=\"n\">{}</td>", html_number(seconds * 1e6, 3));
  const double share = f.max * 90;
  return out + fmt::format("<td class=\"n{}\">{} %{}</td></tr>\n", share > 1 ? " bad" : "", html_number(100 * share, 2),
                           share > 1 ? " – late" : "");
}

}  // namespace

std::string verdict_tag(Verdict v) {
  switch (v) {
    case Verdict::pass:
      return "<span class=\"tag pass\">✓ holds</span>";
    case Verdict::vacuous:
      return "<span class=\"tag vacuous\">○ vacuous</span>";
    case Verdict::fail:
      return "<span class=\"tag fail\">✗ failed</span>";
  }
  return "";
}

std::string html_number(double value, int digits) { return escape(typographic(number(value, digits))); }

std::string html_error(double value, bool relative) { return escape(typographic(error_number(value, relative))); }

std::string gates_section(const compare::SuiteResult& result) {
  const std::vector<PlacedGate> gates = placed_gates(result);
  const Count n = count(gates);
  std::string out = "<section id=\"gates\" aria-labelledby=\"gates-title\"><h2 id=\"gates-title\">Gates</h2>\n";
  if (n.gates == 0) return out + "<p>No gate was judged.</p></section>\n";
  out +=
      "<p class=\"quiet\">A gate is one measured number against one limit. The bar shows how much of the limit is "
      "used; its upright line is the limit.</p>\n";
  out += table(gates, Verdict::fail, fmt::format("Failed: {}", n.failed));
  out += folded(gates, Verdict::vacuous, n.vacuous,
                "could be 100 times tighter and still hold: vacuous, they guard nothing");
  out += folded(gates, Verdict::pass, n.gates - n.failed - n.vacuous, "hold");
  return out + "</section>\n";
}

std::string frames_section(const compare::SuiteResult& result) {
  std::string rows;
  for (const compare::CaseResult& of_case : result.cases) {
    for (const compare::RunResult& run : of_case.runs) {
      if (run.realtime_frame.frames > 0) rows += frame_row(of_case, run);
    }
  }
  if (rows.empty()) return "";
  return fmt::format(
      "<section id=\"frames\" aria-labelledby=\"frames-title\"><h2 id=\"frames-title\">Frame times of the real-time "
      "path</h2>\n"
      "<p class=\"quiet\">CPU time to advance one frame. At 90 Hz a frame lasts 11.1 ms = 11 100 µs.</p>\n"
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Frame times\"><table><caption>Percentiles in "
      "µs</caption><thead><tr><th scope=\"col\">Case and run</th>"
      "<th scope=\"col\" class=\"n\">Frames</th><th scope=\"col\" class=\"n\">p50</th><th scope=\"col\" "
      "class=\"n\">p90</th><th scope=\"col\" class=\"n\">p99</th>"
      "<th scope=\"col\" class=\"n\">p99.9</th><th scope=\"col\" class=\"n\">Slowest</th><th scope=\"col\" "
      "class=\"n\">Slowest of a 90 Hz frame</th></tr></thead><tbody>\n{}</tbody></table></div></section>\n",
      rows);
}

}  // namespace handhold::reports
