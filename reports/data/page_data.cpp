// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/page_data.hpp"

#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/model/input_error.hpp"
#include "reports/data/deflate.hpp"
#include "reports/data/page_frame.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

using Json = nlohmann::ordered_json;

Json parsed(std::string_view text) {
  try {
    Json results = Json::parse(text);
    if (results.value("format", "") == "handhold results" && results.value("version", 0) == 2) return results;
  } catch (const Json::exception&) {
  }
  throw InputError("results: are not JSON of 'handhold results', version 2 (run handhold suite to write them anew)");
}

std::string title(const Json& results) {
  const Json& verdict = results.at("verdict");
  return escape(
      fmt::format("{} {} – handhold", verdict.value("passed", false) ? "✓" : "✗", verdict.value("sentence", "")));
}

/// What the judgements of one engine on one case come to.
struct Cell {
  int gates{}, failed{};
  std::set<std::string> grades{};

  void add(const Json& judgement) {
    if (judgement.contains("limit")) {
      ++gates;
      failed += judgement.value("passes", false) ? 0 : 1;
    } else if (judgement.contains("grade") && judgement["grade"].is_string()) {
      grades.insert(judgement["grade"].get<std::string>());
    }
  }

  [[nodiscard]] std::string text() const {
    if (gates > 0)
      return failed > 0 ? fmt::format("✗ fails {} of {}", failed, gates) : fmt::format("✓ holds {}", gates);
    return grades.empty() ? "not asked" : fmt::format("{}", fmt::join(grades, ", "));
  }
};

Cell cell(const Json& of_case, const Json& engine) {
  Cell out;
  const std::string name = engine.value("name", "");
  for (const Json& run : of_case.at("runs"))
    for (const Json& claim : run.at("claims"))
      for (const char* list : {"judgements", "studies"})
        for (const Json& judgement : claim.value(list, Json::array()))
          if (judgement.value("engine", "") == name) out.add(judgement);
  return out;
}

/// Cases by engines, for a reader without JavaScript.
std::string table(const Json& results) {
  std::string head = "<th>case</th>", rows;
  for (const Json& engine : results.at("engines")) head += fmt::format("<th>{}</th>", escape(engine.value("name", "")));
  for (const Json& of_case : results.at("cases")) {
    rows += fmt::format("<tr><th>{} {}</th>", escape(of_case.value("id", "")), escape(of_case.value("title", "")));
    for (const Json& engine : results.at("engines"))
      rows += fmt::format("<td>{}</td>", escape(cell(of_case, engine).text()));
    rows += "</tr>\n";
  }
  return fmt::format("<table>\n<tr>{}</tr>\n{}</table>\n", head, rows);
}

std::string element(const std::string& name, const std::string& bytes) {
  return fmt::format("<script type=\"text/plain\" id=\"{}\">{}</script>\n", name, base64(bytes));
}

std::string recordings(const Blobs& blobs) {
  std::string out;
  for (const auto& [name, bytes] : blobs) out += element(name, bytes);
  return out;
}

/// `frame` with every <!--handhold:name--> replaced by what `fill` gives for the name.
template <class Fill>
std::string filled(std::string_view frame, Fill fill) {
  static constexpr std::string_view begin = "<!--handhold:", end = "-->";
  std::string out;
  while (true) {
    const std::size_t at = frame.find(begin);
    out += frame.substr(0, at);
    if (at == std::string_view::npos) return out;
    frame.remove_prefix(at + begin.size());
    const std::size_t stop = frame.find(end);
    out += fill(frame.substr(0, stop));
    frame.remove_prefix(stop + end.size());
  }
}

}  // namespace

std::string page(const StoredReport& report) {
  const Json results = parsed(report.results);
  try {
    return filled(page_frame(), [&](std::string_view place) -> std::string {
      if (place == "title") return title(results);
      if (place == "table") return table(results);
      if (place == "results") return base64(deflated(report.results));
      if (place == "times") return base64(deflated(report.times));
      return recordings(report.recordings);
    });
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("results: {} (see reports/data/results.schema.json)", error.what()));
  }
}

}  // namespace handhold::reports
