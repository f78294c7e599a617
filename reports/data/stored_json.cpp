// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/stored_json.hpp"

#include <fmt/format.h>

#include "cases/input/text_encoding.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::reports {

using Json = nlohmann::ordered_json;

Json verdict_json(const compare::Standing& standing) {
  const compare::Count& n = standing.count;
  return {{"passed", compare::passed(standing)},
          {"sentence", compare::verdict_sentence(standing)},
          {"interrupted", standing.interrupted},
          {"gates", n.gates},
          {"failed", n.failed},
          {"vacuous", n.vacuous},
          {"not_asked", n.not_asked},
          {"graded", n.graded}};
}

Json parsed_results(const NamedReport& report) {
  const Json results = Json::parse(report.report.results, nullptr, false);
  if (results.is_object() && results.value("format", "") == "handhold results" && results.value("version", 0) == 2)
    return results;
  throw InputError(fmt::format(
      "{}: is no 'handhold results' of version 2 (give the results.json that this version of handhold writes)",
      report.name));
}

Json parsed_times(const StoredReport& report) {
  const Json times = Json::parse(report.times, nullptr, false);
  if (times.is_object()) return times;
  return {{"format", "handhold times"},
          {"version", 1},
          {"occasion", Json::object()},
          {"seconds", nullptr},
          {"plays", Json::array()}};
}

void append_texts(Json& into, const Json& part, const std::string& label) {
  for (const auto& [key, text] : part.items())
    if (into.value(key, Json()) != text) into[into.contains(key) ? fmt::format("{} ({})", key, label) : key] = text;
}

void append_times(Json& into, const Json& part, const std::string& label) {
  for (const Json& play : part["plays"]) into["plays"].push_back(play);
  append_texts(into["occasion"], part["occasion"], label);
  if (into["seconds"].is_number() && part["seconds"].is_number())
    into["seconds"] = into["seconds"].get<double>() + part["seconds"].get<double>();
}

std::string file_text(const Json& json) {
  return escape_hidden(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace handhold::reports
