// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/stored_report.hpp"

#include <fstream>
#include <iterator>
#include <variant>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "reports/data/packed_recording.hpp"
#include "reports/data/results_json.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Packs the recordings of one run, if its problem is a scene.
void pack(const compare::RunResult& run, Blobs& blobs, RecordingNames& names) {
  const Scene* scene = run.problem ? std::get_if<Scene>(run.problem.get()) : nullptr;
  if (scene == nullptr) return;
  for (const compare::Play& play : run.plays)
    if (play.recording) names[&play] = pack_recording(*scene, *play.recording, blobs);
}

}  // namespace

StoredReport stored_report(const compare::SuiteResult& result) {
  StoredReport out;
  RecordingNames names;
  for (const compare::CaseResult& of_case : result.cases)
    for (const compare::RunResult& run : of_case.runs) pack(run, out.recordings, names);
  out.results = results_json(result);
  out.times = times_json(result, names);
  return out;
}

StoredReport read_report(const fs::path& place) {
  const fs::path results = fs::is_directory(place) ? place / "results.json" : place;
  if (!fs::is_regular_file(results))
    throw InputError(
        fmt::format("{}: there is no such file (give a results.json, or the folder of a report)", results.string()));
  StoredReport out{content(results), content(results.parent_path() / "times.json"), {}};
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(results.parent_path() / "recordings", none))
    out.recordings.emplace(entry.path().filename().string(), content(entry.path()));
  return out;
}

NamedReport read_named_report(const fs::path& place) {
  const fs::path absolute = fs::absolute(place).lexically_normal();
  const fs::path folder = fs::is_directory(absolute) ? absolute / "" : absolute;
  return {folder.parent_path().filename().string(), read_report(place)};
}

}  // namespace handhold::reports
