#include "reports/page.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "reports/data/text.hpp"
#include "reports/page_parts.hpp"

namespace handhold::reports {
namespace {

std::string head(const compare::SuiteResult& result) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{} – handhold</title>\n<style>{}</style>\n</head>\n",
      escape(headline(result)), page_style());
}

std::string banner(const compare::SuiteResult& result) {
  return fmt::format("<header class=\"verdict {}\"><h1>{} {}</h1>\n<p>{}</p></header>\n",
                     compare::passed(result) ? "pass" : "fail", compare::passed(result) ? "✓" : "✗",
                     escape(headline(result)), escape(verdict_sentence(result)));
}

Verdict worst(const compare::CaseResult& of_case) {
  Verdict out = Verdict::pass;
  for (const compare::RunResult& run : of_case.runs) {
    for (const PlacedGate& placed : placed_gates(of_case, run)) out = std::max(out, verdict(*placed.gate));
  }
  return out;
}

std::string contents(const compare::SuiteResult& result) {
  std::string out = "<nav aria-label=\"Cases\"><ul class=\"contents\">";
  for (const compare::CaseResult& of_case : result.cases) {
    out += fmt::format("<li><a href=\"#{}\">{} {}</a> {}</li>", escape("case-" + of_case.id), escape(of_case.id),
                       escape(of_case.title),
                       verdict_tag(worst(of_case) == Verdict::fail ? Verdict::fail : Verdict::pass));
  }
  return out + "</ul></nav>\n";
}

std::string provenance(const compare::SuiteResult& result) {
  std::string out =
      "<section id=\"provenance\" aria-labelledby=\"provenance-title\"><h2 id=\"provenance-title\">What was run</h2>\n";
  const auto command = result.provenance.find("command");
  if (command != result.provenance.end())
    out += fmt::format("<p>To run it again:</p>\n<pre><code>{}</code></pre>\n", escape(command->second));
  out += "<dl>";
  for (const auto& [key, value] : result.provenance) {
    if (key != "command") out += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape(key), escape(value));
  }
  return out + fmt::format("<dt>total time</dt><dd>{}</dd></dl></section>\n", escape(readable(result.seconds, "s")));
}

}  // namespace

std::string page(const compare::SuiteResult& result) {
  std::string out = head(result) + "<body>\n<main>\n" + banner(result) + contents(result) + provenance(result) +
                    gates_section(result) + frames_section(result);
  for (std::size_t i = 0; i < result.cases.size(); ++i) out += case_section(result.cases[i], i);
  return out +
         "<footer>The same numbers are in results.json (for programs), junit.xml (for build servers) and table.txt "
         "beside this page.</footer>\n</main>\n</body>\n</html>\n";
}

}  // namespace handhold::reports
