// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/input/log/object_log.hpp"
#include "cases/input/scene/materials.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/auto_contact.hpp"
#include "compare/engine/engines.hpp"
#include "compare/log/log_judge.hpp"
#include "compare/log/log_replay.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/object_source.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/log_text.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

struct LogCommand {
  std::string file{}, engine{"reference"};
  bool no_replay{false}, json{false};
};

/// A mesh file's path is relative to the log.
std::string beside(const std::string& log, const std::string& shape) {
  if (shape.rfind("shape:", 0) == 0 || fs::path(shape).is_absolute()) return shape;
  return (fs::path(log).parent_path() / shape).string();
}

Body body_of(const LoggedObject& object, const std::string& file) {
  if (object.shape.empty())
    throw InputError(fmt::format("{}: object '{}' has no shape (add \"shape\": a mesh file, or shape:box,x=0.05,...)",
                                 file, object.name));
  const ImportedObject imported = load_object(beside(file, object.shape), object.scale);
  const SolidProperties solid = solid_properties(imported.mesh.mesh);
  const Material& wood = material("wood");  // where the log says nothing
  const double density = object.mass ? *object.mass / solid.volume : wood.density;
  Body body;
  body.name = object.name;
  body.field = imported.field;
  body.inertia = {density * solid.volume, solid.center, density * solid.inertia};
  body.friction = wood.friction();
  if (object.mu_static) body.friction = {*object.mu_static, *object.mu_static};
  if (object.mu_dynamic) body.friction.mu_dynamic = *object.mu_dynamic;
  validate(body, fmt::format("{}: object '{}'", file, object.name));
  return body;
}

void replay(const LogCommand& command, const ObjectLog& log, const std::vector<Body>& bodies,
            const std::vector<compare::ObjectTrack>& tracks, JudgedLog& judged) {
  const auto engine = compare::make_engine(command.engine);
  judged.engine = command.engine;
  ProgressLine progress(ProgressLine::Elsewhere::silent);
  for (const compare::LogGrip& grip : judged.report.grips) {
    progress.step(fmt::format("replaying the grip of {:.2f} s", grip.begin));
    const Body& body = bodies[grip.track];
    const auto contact_of = [&](const Placement& p) { return compare::auto_contact(body, p, PatchOptions{}.samples); };
    judged.replays.push_back(compare::replay_grip(log, tracks[grip.track], grip, body, contact_of, *engine));
    judged.mu_static.push_back(body.friction.mu_static);
  }
}

int judge(const LogCommand& command) {
  const ObjectLog log = read_object_log(command.file);
  std::vector<Body> bodies;
  std::vector<compare::LoggedSolid> solids;
  for (const LoggedObject& object : log.objects) {
    bodies.push_back(body_of(object, command.file));
    solids.push_back({object.name, bodies.back().field, solid_properties(bodies.back().field->mesh())});
  }
  const std::vector<compare::ObjectTrack> tracks = compare::tracks_of(log, solids);
  JudgedLog judged{.name = log.name, .warnings = log.warnings, .report = compare::judge_log(log, tracks, solids)};
  if (!command.no_replay) replay(command, log, bodies, tracks, judged);
  say(command.json ? log_json(judged) : log_text(judged));
  return judged.report.findings.empty() ? exit_good : exit_gate_failed;
}

}  // namespace

void add_judge_log(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("judge-log", "Judge what an application logged of hands and objects");
  const auto options = std::make_shared<LogCommand>();
  command->add_option("log", options->file, "JSON, a line a frame: docs/judge-log.md")->required();
  command
      ->add_option("--engine", options->engine, "that plays each grip again, from where the object rests in the hand")
      ->capture_default_str();
  command->add_flag("--no-replay", options->no_replay, "judge only what needs no engine")->disable_flag_override();
  command->add_flag("--json", options->json, "print the verdict as JSON")->disable_flag_override();
  command->footer(
      "Examples:\n  handhold judge-log session.jsonl\n  handhold judge-log session.jsonl --no-replay --json\n"
      "Exit code: 0 nothing found, 1 something that cannot be, 2 wrong input.");
  command->callback([options, &invocation] { invocation.exit_code = judge(*options); });
}

}  // namespace handhold::reports
