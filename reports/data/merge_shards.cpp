// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/merge_shards.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "reports/data/stored_json.hpp"

namespace handhold::reports {
namespace {

using Json = nlohmann::ordered_json;

/// What one process played.
struct Part {
  std::string name{};
  compare::Shard shard{};
  std::size_t all_runs{};  ///< of the suite
  Json results{};
  std::vector<std::pair<const Json*, const Json*>> runs{};  ///< case and run, in their order

  [[nodiscard]] std::size_t expected_runs() const { return (all_runs + shard.of - shard.index) / shard.of; }
};

Part part_of(const NamedReport& report) {
  Part part{.name = report.name, .results = parsed_results(report)};
  if (!part.results.contains("shard"))
    throw InputError(fmt::format(
        "{}: is no part of a suite (give what handhold suite --shard wrote; handhold report puts whole suites side by "
        "side)",
        part.name));
  const Json& shard = part.results["shard"];
  part.shard = {shard["index"].get<std::size_t>(), shard["of"].get<std::size_t>()};
  part.all_runs = shard["runs"].get<std::size_t>();
  return part;
}

void list_runs(Part& part) {
  for (const Json& of_case : part.results["cases"])
    for (const Json& run : of_case["runs"]) part.runs.emplace_back(&of_case, &run);
  if (part.runs.size() == part.expected_runs()) return;
  throw InputError(
      fmt::format("{}: holds {} of the {} runs of part {} of {} (it was interrupted: play it again with "
                  "--shard {}/{})",
                  part.name, part.runs.size(), part.expected_runs(), part.shard.index, part.shard.of, part.shard.index,
                  part.shard.of));
}

void require_same_suite(const Part& first, const Part& part) {
  if (part.shard.of != first.shard.of || part.all_runs != first.all_runs)
    throw InputError(
        fmt::format("{} is a part of {} with {} runs in all, {} of {} with {} (play all parts with the same "
                    "options)",
                    first.name, first.shard.of, first.all_runs, part.name, part.shard.of, part.all_runs));
  for (const char* key : {"engines", "provenance"}) {
    if (part.results[key] == first.results[key]) continue;
    throw InputError(fmt::format("{} and {} differ in their {} (play all parts with the same program and options)",
                                 first.name, part.name, key));
  }
}

/// One of each, by index.
void require_all(const std::vector<Part>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t index = parts[i].shard.index, of = parts[i].shard.of;
    if (index == i + 1) continue;
    if (index < i + 1)
      throw InputError(fmt::format("{} and {} are both part {} of {} (give each once)", parts[i - 1].name,
                                   parts[i].name, index, of));
    throw InputError(fmt::format("part {0} of {1} is missing (handhold suite --shard {0}/{1})", i + 1, of));
  }
  const std::size_t of = parts.front().shard.of;
  if (parts.size() < of)
    throw InputError(fmt::format("part {0} of {1} is missing (handhold suite --shard {0}/{1})", parts.size() + 1, of));
}

/// The runs in the order of the suite, those of one case in one.
Json cases_of(const std::vector<Part>& parts) {
  Json cases = Json::array();
  for (std::size_t number = 0; number < parts.front().all_runs; ++number) {
    const auto& [of_case, run] = parts[number % parts.size()].runs[number / parts.size()];
    if (cases.empty() || cases.back()["id"] != (*of_case)["id"]) {
      cases.push_back(*of_case);
      cases.back()["runs"] = Json::array();
    }
    cases.back()["runs"].push_back(*run);
  }
  return cases;
}

/// The first failed gate of a run, as compare::standing says it.
std::string first_failure(const Json& of_case, const Json& run) {
  const std::string variant = run["variant"].get<std::string>();
  const std::string place = fmt::format("{}/{}{}{}", of_case["id"].get<std::string>(), run["name"].get<std::string>(),
                                        variant.empty() ? "" : ", ", variant);
  for (const Json& claim : run["claims"])
    for (const char* list : {"judgements", "studies"})
      for (const Json& judged : claim[list])
        if (!judged.value("passes", true)) return fmt::format("{} ({})", judged["sentence"].get<std::string>(), place);
  return "";
}

compare::Standing standing_of(const std::vector<Part>& parts, const Json& cases) {
  compare::Standing out{.cases = cases.size()};
  for (const Part& part : parts) {
    const Json& verdict = part.results["verdict"];
    compare::Count& n = out.count;
    for (const auto& [key, sum] :
         {std::pair{"gates", &n.gates}, std::pair{"failed", &n.failed}, std::pair{"vacuous", &n.vacuous},
          std::pair{"not_asked", &n.not_asked}, std::pair{"graded", &n.graded}})
      *sum += verdict[key].get<std::size_t>();
    out.interrupted = out.interrupted || verdict["interrupted"].get<bool>();
  }
  for (const Json& of_case : cases)
    for (const Json& run : of_case["runs"])
      if (out.first_failure.empty()) out.first_failure = first_failure(of_case, run);
  return out;
}

std::vector<Part> checked_parts(const std::vector<NamedReport>& reports) {
  std::vector<Part> parts;
  for (const NamedReport& report : reports) {
    try {
      parts.push_back(part_of(report));
      require_same_suite(parts.front(), parts.back());
    } catch (const Json::exception& error) {
      throw InputError(fmt::format("{}: {} (see reports/data/results.schema.json)", report.name, error.what()));
    }
  }
  std::ranges::stable_sort(parts, {}, [](const Part& part) { return part.shard.index; });
  require_all(parts);
  for (Part& part : parts) list_runs(part);  // after all moves: it points into the part
  return parts;
}

}  // namespace

StoredReport merged_shards(std::vector<NamedReport> reports) {
  if (reports.empty()) throw InputError("parts of a suite: none are given (name the folders that --shard wrote)");
  const std::vector<Part> parts = checked_parts(reports);
  const Json cases = cases_of(parts);
  Json results{{"format", "handhold results"}, {"version", 2}, {"verdict", verdict_json(standing_of(parts, cases))}};
  for (const char* key : {"provenance", "engines"}) results[key] = parts.front().results[key];
  results["cases"] = cases;
  Json times = parsed_times(reports.front().report);
  StoredReport out{file_text(results), "", {}};
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (i > 0) append_times(times, parsed_times(reports[i].report), reports[i].name);
    out.recordings.merge(reports[i].report.recordings);
  }
  out.times = file_text(times);
  return out;
}

}  // namespace handhold::reports
