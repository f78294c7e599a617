// SPDX-License-Identifier: GPL-3.0-or-later
#include <cctype>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/catalogue/case.hpp"
#include "cases/input/recording/recording_csv.hpp"
#include "cases/input/regular_file.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/mjcf.hpp"
#include "compare/engine/problem_json.hpp"
#include "compare/engine/process.hpp"
#include "compare/judge/judgement.hpp"
#include "compare/measure/measure.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/option_checks.hpp"
#include "reports/cli/terminal.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  std::string id{};
  std::string out{"problems"};
  double step{1.0 / 360};
  int frame_every{4};
};

const catalogue::Case& case_of(const std::string& id) {
  std::string ids;
  for (const catalogue::Case& c : catalogue::all_cases()) {
    if (c.id == id) return c;
    if (c.level == Level::rigid) ids += (ids.empty() ? "" : ", ") + c.id;
  }
  throw InputError(fmt::format("case '{}': there is none (of level L1 there are: {})", id, ids.empty() ? "none" : ids));
}

/// "L1-C03 stops, turned": what a problem file is called, and how its run is found again.
std::string name_of(const catalogue::Case& c, const catalogue::Run& run) {
  return c.id + " " + run.name + (run.variant.empty() ? "" : ", " + run.variant);
}

/// The same as the name of a folder.
std::string folder_of(const catalogue::Case& c, const catalogue::Run& run) {
  std::string name = name_of(c, run);
  for (char& letter : name)
    if (!std::isalnum(static_cast<unsigned char>(letter)) && letter != '.' && letter != '-') letter = '_';
  return name;
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream out(file);
  if (!(out << text << std::flush))
    throw InputError(fmt::format("{}: cannot be written (free space, or give another folder)", file.string()));
}

void export_case(const ExportOptions& options) {
  const catalogue::Case& c = case_of(options.id);
  if (c.level != Level::rigid)
    throw InputError(fmt::format("case '{}': is of level {}, and files hold rigid problems (take one of L1)", c.id,
                                 to_string(c.level)));
  for (const catalogue::Run& run : c.runs) {
    const fs::path folder = fs::path(options.out) / folder_of(c, run);
    const compare::SampledProblem problem =
        compare::sample(std::get<RigidProblem>(run.problem()), name_of(c, run), options.step, options.frame_every);
    std::error_code failed;
    fs::create_directories(folder, failed);
    write(folder / "problem.json", compare::problem_json(problem));
    write(folder / "problem.xml", compare::mjcf(problem));
    say(fmt::format("{}\n", (folder / "problem.json").string()));
  }
}

catalogue::Run find_run(const std::string& name) {
  for (const catalogue::Case& c : catalogue::all_cases())
    for (const catalogue::Run& run : c.runs)
      if (name_of(c, run) == name) return run;
  throw InputError(fmt::format("problem '{}': is no run of the catalogue (export it again)", name));
}

void judge_folder(const std::string& folder) {
  const fs::path file = fs::path(folder) / "problem.json", out = fs::path(folder) / "out";
  const compare::SampledProblem asked = compare::read_problem_json(read_regular_file(file), file.string());
  const Recording recording = read_recording(out);
  if (const std::string fault = compare::answer_fault(recording, asked); !fault.empty())
    throw InputError(fmt::format("{}: {} (play problem.json again)", (out / "frames.csv").string(), fault));
  const catalogue::Run run = find_run(asked.name);
  const compare::EngineInfo engine{.name = recording.engine, .levels = {Level::rigid}};
  const Problem problem = run.problem();
  say(fmt::format("{}, played by {}\n", asked.name,
                  recording.engine.empty() ? "an engine without a name" : recording.engine));
  for (const catalogue::Claim& claim : run.claims) {
    const std::string why = compare::why_not_asked(claim, engine);
    const compare::Judgement j = compare::judge(claim, engine, compare::measure(problem, recording, claim.measure));
    const std::string verdict = why.empty() ? fmt::format("{:.6g} {}, truth {:.6g}: {}", j.value, claim.unit,
                                                          claim.truth, compare::to_string(*j.grade))
                                            : "not asked: " + why;
    say(fmt::format("  {}: {}\n", claim.quantity, verdict));
  }
}

}  // namespace

void add_export(CLI::App& app, Invocation&) {
  CLI::App* command = app.add_subcommand("export", "Write the problems of a case for engines of others");
  const auto options = std::make_shared<ExportOptions>();
  command->add_option("case", options->id, "of level L1")->required();
  command->add_option("--out", options->out, "folder; CASE/RUN is made in it")->capture_default_str();
  command->add_option("--step", options->step, "of the engine [s]")->check(number_in(1e-6, 1))->capture_default_str();
  command->add_option("--frame-every", options->frame_every, "steps from one frame of the answer to the next")
      ->check(number_in(1, 1e6))
      ->capture_default_str();
  command->footer("Examples:\n  handhold export L1-C03\n  handhold export L1-D01 --out problems --step 0.001");
  command->callback([options] { export_case(*options); });
}

void add_judge(CLI::App& app, Invocation&) {
  CLI::App* command = app.add_subcommand("judge", "Grade what an engine wrote for an exported problem");
  const auto folder = std::make_shared<std::string>();
  command->add_option("folder", *folder, "with problem.json, as export wrote it, and out/frames.csv")->required();
  command->footer("Example:\n  handhold judge problems/L1-C03_stops");
  command->callback([folder] { judge_folder(*folder); });
}

}  // namespace handhold::reports
