// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/hand/built_grasps.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/auto_contact.hpp"
#include "compare/engine/engines.hpp"
#include "compare/study/grasp_table.hpp"
#include "compare/study/horizon.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/interrupt.hpp"
#include "reports/cli/option_checks.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/scene_source.hpp"
#include "reports/data/grasp_table_text.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

struct GraspsCommand {
  std::string folder{};
  std::vector<std::string> shapes{"shape:box",    "shape:cylinder", "shape:sphere", "shape:mug",
                                  "shape:hammer", "shape:card",     "shape:bowl",   "shape:bottle"};
  std::string engine{"both"};
  std::size_t tries{24};
  bool json{false};
};

bool is_trace(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(".json") || name.ends_with(".json.lz") || name.ends_with(".csv");
}

/// Those of the folder and of the folders in it, in order of name.
std::vector<Trace> recordings_in(const std::string& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && is_trace(entry.path())) files.push_back(entry.path());
  if (files.empty()) throw InputError(fmt::format("{}: holds no recording (.json, .json.lz or .csv)", folder));
  std::sort(files.begin(), files.end());
  std::vector<Trace> traces;
  for (const fs::path& file : files) traces.push_back(read_trace(file.string()));
  return traces;
}

std::vector<compare::GraspPair> pairs_of(const GraspsCommand& command) {
  std::vector<Trace> traces;
  if (!command.folder.empty()) traces = recordings_in(command.folder);
  for (Trace& built : built_grasps()) traces.push_back(std::move(built));
  std::vector<Body> bodies;
  for (const std::string& shape : command.shapes) {
    SceneRequest request;
    request.object = shape;
    bodies.push_back(load_body(request));
  }
  std::vector<compare::GraspPair> pairs;
  for (const Trace& trace : traces) {
    const auto shared = std::make_shared<const Trace>(trace);
    for (std::size_t hand = 0; hand < trace.hands.size(); ++hand)
      for (const Body& body : bodies) pairs.push_back({trace.name, shared, hand, body});
  }
  return pairs;
}

void execute(const GraspsCommand& command, Invocation& invocation) {
  compare::GraspTableOptions options;
  if (command.engine != "both") options.engines = {command.engine};
  options.make_engine = compare::make_engine;
  options.tried = command.tries;
  options.contact_of = [](const Body& body, const Placement& placement) {
    return compare::auto_contact(body, placement, PatchOptions{}.samples);
  };
  options.horizon = [](const Scene& scene, const compare::Engine& engine, const compare::EngineOptions& settings,
                       const Recording& run) { return compare::horizon(scene, engine, settings, run).t; };
  const std::vector<compare::GraspPair> pairs = pairs_of(command);
  if (!command.json) fmt::print("{}", grasp_table_head(options.engines));
  std::vector<compare::GraspRow> rows;
  ProgressLine progress;
  for (const compare::GraspPair& pair : pairs) {
    if (interrupted()) break;
    progress.step(fmt::format("{} with {}", pair.recording, pair.body.name));
    rows.push_back(compare::play_grasp(pair, options));
    if (!command.json) fmt::print("{}", grasp_row_text(rows.back()));
    std::fflush(stdout);  // a row can take a minute
  }
  fmt::print("{}", command.json ? grasp_table_json(rows) : grasp_totals(rows));
  if (interrupted()) invocation.exit_code = exit_gate_failed;
}

}  // namespace

void add_grasps(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "grasps", "Put objects into every recorded and built grasp by trial, and tell how long each engine holds them");
  const auto options = std::make_shared<GraspsCommand>();
  command->add_option("--traces", options->folder, "folder of recordings; the built grasps are played in any case")
      ->check(CLI::ExistingDirectory);
  command->add_option("--shapes", options->shapes, "objects: mesh files or shape:kind")->capture_default_str();
  command->add_option("--engine", options->engine, "which engine plays what was placed")
      ->check(CLI::IsMember({"both", "realtime", "reference"}))
      ->capture_default_str();
  command->add_option("--tries", options->tries, "placements that are played for each pair")
      ->check(number_in(1, 1000))
      ->capture_default_str();
  command->add_flag("--json", options->json, "print the table as JSON")->disable_flag_override();
  command->footer(
      "Examples:\n  handhold grasps --engine realtime\n  handhold grasps --traces recordings --shapes shape:mug "
      "mug.obj "
      "--json");
  command->callback([options, &invocation] { execute(*options, invocation); });
}

}  // namespace handhold::reports
