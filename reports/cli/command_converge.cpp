// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/catalogue/scenes/certification_scenes.hpp"
#include "cases/catalogue/scenes/limit_scenes.hpp"
#include "cases/input/recording/recording_csv.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/engines.hpp"
#include "compare/measure/measure.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/interrupt.hpp"
#include "reports/cli/option_checks.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/scene_source.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/convergence_text.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

struct ConvergeCommand {
  std::string engine{"reference"};
  std::vector<std::string> scenes{};
  std::string independent{};
  bool stiffness{};
  double accuracy{1e-9};  // of the reference in --stiffness
};

/// A certification scene, or a file's.
struct Subject {
  std::string name{}, what{};
  std::function<Scene()> scene{};
  std::vector<catalogue::Claim> claims{};
  bool costly{};
};

constexpr double certified = 1e-10;  // the accuracy whose limits the runs are measured in

bool is_file(const std::string& name) { return fs::path(name).has_extension() || fs::exists(name); }

Subject subject_of(const std::string& name) {
  if (is_file(name)) {
    SceneRequest request;
    request.scene_file = name;
    const NamedScene loaded = load_scenes(request).front();
    return {loaded.name, name, [scene = loaded.scene] { return scene; }, {}, false};
  }
  const catalogue::CertificationScene& c = catalogue::certification_scene(name);
  return {c.name, c.what, c.scene, c.claims, c.costly};
}

std::vector<Subject> subjects(const std::vector<std::string>& names) {
  std::vector<Subject> out;
  for (const std::string& name : names) out.push_back(subject_of(name));
  if (!names.empty()) return out;
  for (const catalogue::CertificationScene& c : catalogue::certification_scenes()) out.push_back(subject_of(c.name));
  return out;
}

std::vector<compare::Setting> settings_for(const std::string& engine, bool costly) {
  std::vector<compare::Setting> settings =
      engine == "reference" ? compare::reference_settings() : compare::realtime_settings();
  if (costly) settings.erase(settings.begin(), settings.end() - 3);  // its cost is what is asked for
  return settings;
}

/// How far each run is from the closed forms, in units of their limits.
void judge_by_closed_form(const Subject& subject, const Scene& scene, NamedConvergence& named) {
  if (subject.claims.empty()) return;
  for (const compare::ConvergenceRun& run : named.study.runs) {
    double worst = 0;
    named.closed_form_lines.clear();
    for (const catalogue::Claim& e : subject.claims) {
      const double error = std::abs(compare::measure(scene, run.recording, e.measure) - e.truth);
      const double limit = compare::limit_value(e.controlled, {compare::ErrorModel::Kind::controlled, certified, 0});
      if (!(error / limit <= worst)) worst = error / limit;
      named.closed_form_lines.push_back(fmt::format("{} {:.12g} {}, off by {:.1e} at {} ({})", e.quantity, e.truth,
                                                    e.unit, error, run.setting.name, e.source));
    }
    named.closed_form.push_back(worst);
  }
}

void judge_by_recording(const std::string& folder, const Subject& subject, NamedConvergence& named) {
  if (folder.empty()) return;
  const fs::path path = fs::path(folder) / subject.name;
  if (!fs::exists(path) && subject.costly) return;  // runs for the cost alone
  if (!fs::exists(path))
    throw InputError(fmt::format("--independent {}: has no recording of '{}' (add {}, or name the scenes with --scene)",
                                 folder, subject.name, path.string()));
  const Recording other = read_recording(path);
  for (const compare::ConvergenceRun& run : named.study.runs)
    named.independent.push_back(compare::gap(run.recording, other));
}

NamedConvergence study(const Subject& subject, const ConvergeCommand& command) {
  const Scene scene = subject.scene();
  ProgressLine progress;
  std::string at;
  const auto watch = [&](const compare::Setting& setting, double t) {
    if (at != setting.name) progress.step(fmt::format("{} {}", subject.name, setting.name));
    at = setting.name;
    progress.update(fmt::format("{:.2f} of {:.2f} s", t, scene.duration));
    return !interrupted();
  };
  NamedConvergence named{subject.name, subject.what, {}, {}, {}, {}};
  named.study = compare::self_convergence(*compare::make_engine(command.engine), scene,
                                          settings_for(command.engine, subject.costly), watch);
  judge_by_closed_form(subject, scene, named);
  judge_by_recording(command.independent, subject, named);
  return named;
}

/// Every promise of a setting, by the run itself, and by closed form and independent recording where there are some.
bool holds(const NamedConvergence& named) {
  bool good = true;
  for (std::size_t i = 0; i < named.study.runs.size(); ++i) {
    const compare::ConvergenceRun& run = named.study.runs[i];
    good = good && run.kept;
    if (!run.setting.promise) continue;
    if (i < named.closed_form.size()) good = good && named.closed_form[i] <= 1;
    if (i >= named.independent.size()) continue;
    const compare::Gap &gap = named.independent[i], &promise = *run.setting.promise;
    good = good && gap.position <= promise.position && gap.rotation <= promise.rotation &&
           gap.event_time <= promise.event_time && gap.unlike_samples == 0;
  }
  return good;
}

std::string cost_text(const NamedConvergence& named, std::size_t contacts) {
  std::string out;
  for (const compare::ConvergenceRun& run : named.study.runs)
    out += fmt::format("  {:<4} contacts      {:<18} {:.3g} CPU s a simulated second\n", contacts, run.setting.name,
                       run.cost);
  return out;
}

std::size_t contacts_of(const NamedConvergence& named) {
  const Recording& recording = named.study.runs.back().recording;
  return recording.frames.empty() ? 0 : recording.frames.back().contacts.size();
}

void converge(const ConvergeCommand& command, Invocation& invocation) {
  std::string costs;
  int broken = 0;
  const std::vector<Subject> all = subjects(command.scenes);
  say(fmt::format(
      "Error against the tightest run plus that run's own (~: estimated by the slope). (n)!: samples with other "
      "events.\n{}",
      convergence_heading()));
  for (const Subject& subject : all) {
    if (interrupted()) break;
    const NamedConvergence named = study(subject, command);
    if (named.study.runs.empty()) break;
    say(convergence_rows(named));
    std::fflush(stdout);
    broken += !holds(named);
    if (subject.name == "twist16" || subject.costly) costs += cost_text(named, contacts_of(named));
  }
  if (!costs.empty()) say(fmt::format("Cost\n{}", costs));
  if (command.engine == "reference")
    say(fmt::format("{}\n", broken == 0 ? "Every promise of the presets is kept."
                                        : fmt::format("The presets' promises are BROKEN on {} scenes.", broken)));
  if (interrupted()) say("Interrupted: later runs are missing.\n");
  if (broken > 0 || interrupted()) invocation.exit_code = exit_gate_failed;
}

const catalogue::LimitScene& limit_scene(const std::string& name) {
  std::string known;
  for (const catalogue::LimitScene& s : catalogue::limit_scenes()) {
    if (s.name == name) return s;
    known += (known.empty() ? "'" : ", '") + s.name + "'";
  }
  throw InputError(fmt::format("scene '{}': has no rigid limit in closed form (there are {})", name, known));
}

void extrapolate(const ConvergeCommand& command, Invocation& invocation) {
  std::vector<catalogue::LimitScene> scenes = catalogue::limit_scenes();
  if (!command.scenes.empty()) scenes.clear();
  for (const std::string& name : command.scenes) scenes.push_back(limit_scene(name));
  const std::unique_ptr<compare::Engine> engine = compare::make_engine(command.engine);
  compare::EngineOptions options;
  options.accuracy = command.accuracy;
  if (command.engine == "realtime") {  // its own error must lie below the stiffness's
    options.frame_rate = 1440;
    options.substeps = 16;
  }
  for (const catalogue::LimitScene& scene : scenes) {
    ProgressLine progress;
    progress.step(fmt::format("{} at {} stiffnesses", scene.name, scene.stiffness.size()));
    const compare::Extrapolation result =
        compare::extrapolate_to_rigid(*engine, scene.scene, scene.measure, scene.stiffness, options, [&](double t) {
          progress.update(fmt::format("{:.2f} s", t));
          return !interrupted();
        });
    if (interrupted()) break;
    say(stiffness_rows(scene, result));
    if (!reaches_truth(scene, result)) invocation.exit_code = exit_gate_failed;
  }
  if (interrupted()) invocation.exit_code = exit_gate_failed;
}

void execute(const ConvergeCommand& command, Invocation& invocation) {
  if (!command.independent.empty() && !fs::is_directory(command.independent))
    throw InputError(
        fmt::format("--independent {}: is no folder (give one with a recording a scene)", command.independent));
  command.stiffness ? extrapolate(command, invocation) : converge(command, invocation);
}

}  // namespace

void add_converge(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "converge", "Run scenes at growing accuracy or stiffness, and say what error, order and cost they show");
  const auto options = std::make_shared<ConvergeCommand>();
  command->add_option("--engine", options->engine, "which engine")
      ->check(CLI::IsMember({"reference", "realtime"}))
      ->capture_default_str();
  command
      ->add_option(
          "--scene", options->scenes,
          "a certification scene by name, or a scene file; may be repeated (default: all certification scenes)")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* stiffness =
      command
          ->add_flag("--stiffness", options->stiffness,
                     "continue compliant contact to the rigid limit, K to infinity, against closed forms of L1")
          ->disable_flag_override();
  command
      ->add_option("--independent", options->independent,
                   "folder with a recording by another solver a scene (FOLDER/SCENE/frames.csv, ...): compare with it")
      ->excludes(stiffness);
  command->add_option("--accuracy", options->accuracy, "of the reference's integrator, with --stiffness")
      ->check(number_in(1e-13, 1e-3))
      ->needs(stiffness)
      ->capture_default_str();
  command->footer(
      "Examples:\n  handhold converge                          every certification scene through the reference\n"
      "  handhold converge --scene twist16 --scene tilt\n  handhold converge --scene scene.toml --engine realtime\n"
      "  handhold converge --stiffness              the rigid limit of compliant contact\n"
      "Exit code 1: a preset of the reference broke its promise (reference: 1e-7 m, 1e-6 rad, 1e-6 s; gold: 4e-10 m, "
      "1e-8 rad, 1e-8 s;\nthe same events), a rigid limit missed its closed form, or it was interrupted.");
  command->callback([options, &invocation] { execute(*options, invocation); });
}

}  // namespace handhold::reports
