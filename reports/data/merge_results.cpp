// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/merge_results.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cases/input/text_encoding.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::reports {
namespace {

using Json = nlohmann::ordered_json;
using Keys = std::vector<const char*>;

Json parsed(const NamedReport& part) {
  const Json results = Json::parse(part.report.results, nullptr, false);
  if (results.is_object() && results.value("format", "") == "handhold results" && results.value("version", 0) == 2)
    return results;
  throw InputError(fmt::format(
      "{}: is no 'handhold results' of version 2 (give the results.json that this version of handhold writes)",
      part.name));
}

/// Calls `visit` with every place that names an engine below a case.
template <class Visit>
void for_each_engine(Json& of_case, Visit visit) {
  for (Json& run : of_case["runs"]) {
    for (Json& play : run["plays"]) visit(play["engine"]);
    for (Json& claim : run["claims"])
      for (const char* list : {"judgements", "studies"})
        for (Json& judgement : claim[list]) visit(judgement["engine"]);
  }
}

/// Engine and case of everything that was played.
std::set<std::pair<std::string, std::string>> played(Json& results) {
  std::set<std::pair<std::string, std::string>> out;
  for (Json& of_case : results["cases"])
    for_each_engine(of_case, [&](const Json& engine) { out.emplace(engine, of_case["id"]); });
  return out;
}

void rename(Json& results, Json& times, const std::string& from, const std::string& to) {
  for (Json& play : times["plays"])
    if (play["engine"] == from) play["engine"] = to;
  for (Json& engine : results["engines"])
    if (engine["name"] == from) engine["name"] = to;
  for (Json& of_case : results["cases"]) {
    for_each_engine(of_case, [&](Json& engine) {
      if (engine == from) engine = to;
    });
    for (Json& run : of_case["runs"]) {
      if (!run["curve"].is_object() || !run["curve"]["engines"].contains(from)) continue;
      run["curve"]["engines"][to] = run["curve"]["engines"][from];
      run["curve"]["engines"].erase(from);
    }
  }
}

void rename_doubles(Json& into, Json& part, Json& times, const std::string& label) {
  const auto before = played(into), now = played(part);
  std::set<std::string> doubles;
  for (const auto& key : now)
    if (before.contains(key)) doubles.insert(key.first);
  for (const std::string& name : doubles) rename(part, times, name, fmt::format("{} ({})", name, label));
}

Json* found(Json& list, const Json& item, const Keys& keys) {
  const auto same = [&](const Json& other) {
    return std::ranges::all_of(keys,
                               [&](const char* key) { return other.value(key, Json()) == item.value(key, Json()); });
  };
  const auto at = std::find_if(list.begin(), list.end(), same);
  return at == list.end() ? nullptr : &*at;
}

void append(Json& into, const Json& list) {
  for (const Json& item : list) into.push_back(item);
}

void merge_curve(Json& into, const Json& part) {
  if (!part.is_object()) return;
  if (!into.is_object()) {
    into = part;
  } else if (into["t"] == part["t"]) {  // at other instants, a curve cannot be drawn beside it
    for (const auto& [name, values] : part["engines"].items()) into["engines"][name] = values;
  }
}

void merge_run(Json& into, const Json& part) {
  for (const Json& claim : part["claims"]) {
    Json* same = found(into["claims"], claim, {"quantity"});
    if (!same) {
      into["claims"].push_back(claim);
      continue;
    }
    append((*same)["judgements"], claim["judgements"]);
    append((*same)["studies"], claim["studies"]);
  }
  append(into["plays"], part["plays"]);
  merge_curve(into["curve"], part["curve"]);
}

void merge_case(Json& into, const Json& part) {
  for (const Json& run : part["runs"]) {
    Json* same = found(into["runs"], run, {"name", "variant"});
    if (same)
      merge_run(*same, run);
    else
      into["runs"].push_back(run);
  }
}

void merge_verdict(Json& into, const Json& part) {
  for (const char* key : {"gates", "failed", "vacuous", "not_asked", "graded"})
    into[key] = into[key].get<int>() + part[key].get<int>();
  into["passed"] = into["passed"].get<bool>() && part["passed"].get<bool>();
  into["interrupted"] = into["interrupted"].get<bool>() || part["interrupted"].get<bool>();
  into["sentence"] = fmt::format("{}; {}", into["sentence"].get<std::string>(), part["sentence"].get<std::string>());
}

/// Texts that differ stand beside each other.
void merge_texts(Json& into, const Json& part, const std::string& label) {
  for (const auto& [key, text] : part.items())
    if (into.value(key, Json()) != text) into[into.contains(key) ? fmt::format("{} ({})", key, label) : key] = text;
}

void merge_results(Json& into, const Json& part, const std::string& label) {
  for (const Json& engine : part["engines"])
    if (!found(into["engines"], engine, {"name"})) into["engines"].push_back(engine);
  for (const Json& of_case : part["cases"]) {
    Json* same = found(into["cases"], of_case, {"id"});
    if (same)
      merge_case(*same, of_case);
    else
      into["cases"].push_back(of_case);
  }
  merge_verdict(into["verdict"], part["verdict"]);
  merge_texts(into["provenance"], part["provenance"], label);
}

void merge_times(Json& into, const Json& part, const std::string& label) {
  append(into["plays"], part["plays"]);
  merge_texts(into["occasion"], part["occasion"], label);
  if (into["seconds"].is_number() && part["seconds"].is_number())
    into["seconds"] = into["seconds"].get<double>() + part["seconds"].get<double>();
}

/// Times are no need of a report: where there are none, an empty list.
Json times_of(const StoredReport& report) {
  const Json times = Json::parse(report.times, nullptr, false);
  if (times.is_object()) return times;
  return {{"format", "handhold times"},
          {"version", 1},
          {"occasion", Json::object()},
          {"seconds", nullptr},
          {"plays", Json::array()}};
}

std::string text(const Json& json) {
  return escape_hidden(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace

StoredReport merged(std::vector<NamedReport> parts) {
  if (parts.empty()) throw InputError("results: none are given (name at least one results.json)");
  Json results = parsed(parts.front()), times = times_of(parts.front().report);
  Blobs recordings = std::move(parts.front().report.recordings);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    NamedReport& part = parts[i];
    Json more = parsed(part), more_times = times_of(part.report);
    try {
      rename_doubles(results, more, more_times, part.name);
      merge_results(results, more, part.name);
      merge_times(times, more_times, part.name);
    } catch (const Json::exception& error) {
      throw InputError(fmt::format("{}: {} (see reports/data/results.schema.json)", part.name, error.what()));
    }
    recordings.merge(part.report.recordings);
  }
  return {text(results), text(times), std::move(recordings)};
}

}  // namespace handhold::reports
