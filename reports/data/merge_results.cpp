// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/merge_results.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "reports/data/stored_json.hpp"

namespace handhold::reports {
namespace {

using Json = nlohmann::ordered_json;
using Keys = std::vector<const char*>;

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
  append_texts(into["provenance"], part["provenance"], label);
}

}  // namespace

StoredReport merged(std::vector<NamedReport> parts) {
  if (parts.empty()) throw InputError("results: none are given (name at least one results.json)");
  Json results = parsed_results(parts.front()), times = parsed_times(parts.front().report);
  Blobs recordings = std::move(parts.front().report.recordings);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    NamedReport& part = parts[i];
    Json more = parsed_results(part), more_times = parsed_times(part.report);
    try {
      rename_doubles(results, more, more_times, part.name);
      merge_results(results, more, part.name);
      append_times(times, more_times, part.name);
    } catch (const Json::exception& error) {
      throw InputError(fmt::format("{}: {} (see reports/data/results.schema.json)", part.name, error.what()));
    }
    recordings.merge(part.report.recordings);
  }
  return {file_text(results), file_text(times), std::move(recordings)};
}

}  // namespace handhold::reports
