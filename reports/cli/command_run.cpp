// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/input/recording/recording_csv.hpp"
#include "cases/input/trace/trace_csv.hpp"
#include "cases/model/frame_times.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/drawn_hand.hpp"
#include "compare/engine/engines.hpp"
#include "compare/measure/grasp.hpp"
#include "compare/study/horizon.hpp"
#include "compare/study/substeps.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/interrupt.hpp"
#include "reports/cli/option_checks.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/scene_source.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/grasp_text.hpp"
#include "reports/data/text.hpp"
#include "reports/data/write_report.hpp"

namespace handhold::reports {
namespace {

struct RunCommand {
  SceneRequest request{};
  compare::EngineOptions engine{};
  bool frames_of_trace{false};
  std::string engine_name{"both"};
  bool no_horizon{false};
  std::string visual_hand{};  ///< "whole", "finger"; empty: none
  std::string out{};
};

struct TimedRecording {
  Recording recording{};
  double seconds{};
};

/// Shows the simulated time in `line`; false when the user has had enough.
compare::Progress shown(ProgressLine& line, const std::string& what, const NamedScene& named) {
  line.step(fmt::format("{} {}", what, named.name));
  return [&line, end = named.scene.duration](double t) {
    line.update(fmt::format("{:.2f} of {:.2f} s", t, end));
    return !interrupted();
  };
}

TimedRecording simulate(const std::string& engine, const NamedScene& named, const compare::EngineOptions& options) {
  ProgressLine progress;
  const auto start = std::chrono::steady_clock::now();
  TimedRecording out;
  out.recording = compare::make_engine(engine)->play(named.scene, options, shown(progress, engine, named));
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return out;
}

/// Those that play scenes.
std::vector<std::string> engine_choices() {
  std::vector<std::string> names;
  for (const std::string& name : compare::engine_names()) {
    const std::vector<Level> levels = compare::make_engine(name)->info({}).levels;
    if (std::find(levels.begin(), levels.end(), Level::compliant) != levels.end()) names.push_back(name);
  }
  names.emplace_back("both");
  return names;
}

/// "both": the reference and the real-time path.
std::vector<std::string> engines(const std::string& name) {
  return name == "both" ? std::vector<std::string>{"reference", "realtime"} : std::vector<std::string>{name};
}

/// The drawn hand beside the real-time path: prints what it did, and writes it as a trace.
void draw(const NamedScene& named, const Recording& recording, const RunCommand& command,
          const std::filesystem::path& out) {
  const compare::DrawnMode mode =
      command.visual_hand == "whole" ? compare::DrawnMode::whole : compare::DrawnMode::finger;
  const compare::DrawnHands drawn = compare::draw_hands(named.scene, recording, mode);
  say(drawn_hands_text(drawn));
  if (out.empty()) return;
  const std::filesystem::path file = out / recording.engine / "drawn_hand.csv";
  write_trace_csv(drawn.trace, file.string());
  say(summary_line("trace", file.string()));
}

/// Prints until when the reference's answer means something; nothing if the second run was interrupted.
std::optional<double> say_horizon(const NamedScene& named, const compare::EngineOptions& options,
                                  const Recording& recording) {
  ProgressLine progress;
  const compare::Horizon horizon = compare::horizon(named.scene, *compare::make_engine("reference"), options, recording,
                                                    shown(progress, "horizon", named));
  if (interrupted()) return {};
  say(horizon_text(horizon));
  return horizon.t;
}

/// A grip has been asked in the trial; a case is played as the suite plays it.
bool chooses_substeps(const RunCommand& command, const NamedScene& named) {
  return !command.request.substeps && !named.substeps && command.request.case_name.empty();
}

/// Plays the scene again where its fastest motion asks for more sub-steps.
void refine(TimedRecording& timed, const NamedScene& named, compare::EngineOptions options) {
  const int needed =
      compare::needed_substeps(compare::fastest_motion(named.scene, timed.recording), options.frame_rate);
  if (needed <= options.substeps) return;
  options.substeps = needed;
  timed = simulate("realtime", named, options);
}

/// Runs the engines on one scene, prints what they say, and writes their recordings. False if a run did not get to its
/// end.
bool run_scene(const NamedScene& named, const RunCommand& command, const std::filesystem::path& out) {
  say(scene_text(named));
  std::vector<Recording> recordings;
  bool complete = true;
  std::optional<double> horizon;
  compare::EngineOptions options = command.engine;
  if (command.request.substeps) options.substeps = *command.request.substeps;
  if (command.frames_of_trace) options.frame_times = trace_frames(named.scene);
  if (!command.request.substeps) options.substeps = named.substeps.value_or(options.substeps);
  for (const std::string& engine : engines(command.engine_name)) {
    TimedRecording timed = simulate(engine, named, options);
    if (engine == "realtime" && chooses_substeps(command, named)) refine(timed, named, options);
    say(grasp_text(compare::summarize(named.scene, timed.recording), timed.recording, timed.seconds));
    if (!out.empty()) {
      write_recording(timed.recording, out / engine);
      say(fmt::format("  recording         {}\n", (out / engine).string()));
    }
    if (engine == "reference" && !command.no_horizon && !interrupted())
      horizon = say_horizon(named, options, timed.recording);
    if (engine == "realtime" && !command.visual_hand.empty()) draw(named, timed.recording, command, out);
    complete = complete && timed.recording.outcome == Outcome::complete;
    recordings.push_back(std::move(timed.recording));
    if (interrupted()) break;
  }
  if (recordings.size() == 2) {
    const double until = horizon.value_or(recordings[0].frames.back().t);
    say(difference_text(compare::difference(recordings[0], recordings[1], until), until));
  }
  return complete;
}

/// "slides, 0.98 of the threshold" as the name of a folder.
std::string folder_name(const std::string& name) {
  std::string out;
  for (const char c : name) out += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ? c : '-';
  return out;
}

/// Before the first run, not after it.
void check_visual_hand(const RunCommand& command, const std::vector<NamedScene>& scenes) {
  if (command.visual_hand.empty()) return;
  if (command.engine_name != "both" && command.engine_name != "realtime")
    throw InputError("--visual-hand with --engine " + command.engine_name +
                     ": is drawn beside the real-time path (use --engine realtime, or both)");
  for (const NamedScene& named : scenes) compare::check_drawable(named.scene);
}

void execute(const RunCommand& command, Invocation& invocation) {
  if (!command.out.empty()) make_writable_folder(command.out);  // now, not after the first run
  const std::vector<NamedScene> scenes = load_scenes(command.request);
  check_visual_hand(command, scenes);
  for (std::size_t i = 0; i < scenes.size() && !interrupted(); ++i) {
    if (i > 0) say("\n");
    std::filesystem::path out = command.out;
    if (!out.empty() && scenes.size() > 1) out /= folder_name(scenes[i].name);
    if (!run_scene(scenes[i], command, out)) invocation.exit_code = exit_gate_failed;
  }
  if (!interrupted()) return;
  say("Interrupted: the last run is partial, and later ones are missing.\n");
  invocation.exit_code = exit_gate_failed;
}

/// "auto" or a number; the default is auto for an object in a recorded hand, else the scene's own.
void add_stiffness(CLI::App& command, SceneRequest& request) {
  const auto take = [&request](const std::string& text) {
    request.auto_stiffness = text == "auto";
    if (!request.auto_stiffness) request.stiffness = std::stod(text);
  };
  command
      .add_option_function<std::string>(
          "--stiffness", take,
          "of each contact sample [N/m]; auto, the default with --trace, suits the object's weight and the grip")
      ->check(number_in(1e-3, 1e9) | CLI::IsMember({"auto"}))
      ->type_name("auto|NUMBER");
}

void add_source(CLI::App& command, SceneRequest& request) {
  CLI::Option* scene = command.add_option("scene", request.scene_file, "scene file (TOML)");
  CLI::Option* of_case =
      command.add_option("--case", request.case_name, "a case of the catalogue, C01, or one run of it, C01/NAME");
  CLI::Option* trace = command.add_option("--trace", request.trace_file, "recording of hands, with --mesh");
  CLI::Option* mesh =
      command.add_option("--mesh", request.object, "the object: a mesh file or shape:kind, with --trace");
  scene->excludes(of_case)->excludes(trace)->excludes(mesh);
  of_case->excludes(trace)->excludes(mesh);
  trace->needs(mesh);
  mesh->needs(trace);
  add_trace_flags(command, request.reading);
  for (const char* flag : {"--repair", "--trust"}) command.get_option(flag)->needs(trace);
  command.add_option("--scale", request.scale, "the mesh file's units to metres")
      ->check(number_in(1e-9, 1e9))
      ->needs(mesh)
      ->capture_default_str();
  command
      .add_option("--place", request.place,
                  "'auto' puts the object into the grasp that holds it best, by trial; or its pose at t = 0, "
                  "x,y,z[,qw,qx,qy,qz] [m]")
      ->needs(mesh)
      ->capture_default_str();
  command
      .add_option("--held-until", request.held_until,
                  "a support holds the object up, as in thick oil, until then [s of the scene]")
      ->check(number_in(0, 3600))
      ->needs(mesh);
  command.add_option("--hand", request.hand, "which hand of the trace, from 0")
      ->check(number_in(0, 15))
      ->needs(mesh)
      ->capture_default_str();
  command.add_option("--material", request.material, "friction and density, see handhold list --materials")
      ->needs(mesh)
      ->capture_default_str();
  CLI::Option* mass =
      command.add_option("--mass", request.mass, "of the object [kg]")->check(number_in(1e-6, 1e3))->needs(mesh);
  command.add_option("--density", request.density, "of the object [kg/m³]")
      ->check(number_in(1e-3, 1e5))
      ->needs(mesh)
      ->excludes(mass);
  add_stiffness(command, request);
  command.add_option("--damping", request.damping, "of each contact sample [N s/m]")->check(number_in(0, 1e6));
  command.add_option("--duration", request.duration, "seconds to simulate")->check(number_in(1e-3, 3600));
}

}  // namespace

void add_run(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("run", "Simulate one scene, one case, or an object in a recorded hand, and say what happened");
  const auto options = std::make_shared<RunCommand>();
  add_source(*command, options->request);
  command->add_option("--engine", options->engine_name, "which engine")
      ->check(CLI::IsMember(engine_choices()))
      ->capture_default_str();
  command->add_option("--frame-rate", options->engine.frame_rate, "frames a second [Hz]")
      ->check(number_in(1, 1e4))
      ->capture_default_str();
  command
      ->add_flag("--frames-of-trace", options->frames_of_trace,
                 "frames are those of the recorded hand, instead of a fixed rate")
      ->disable_flag_override()
      ->excludes(command->get_option("--frame-rate"));
  command
      ->add_flag(
          "--exact-mesh", options->engine.exact_mesh,
          "the reference touches the triangles of smooth bodies, too, instead of the spline of their voxels: the "
          "difference is the voxels' error")
      ->disable_flag_override();
  command
      ->add_flag("--no-horizon", options->no_horizon,
                 "spare the second run of the reference that tells until when its answer means something")
      ->disable_flag_override();
  command
      ->add_option("--substeps", options->request.substeps,
                   "sub-steps a frame of the real-time path; default: as many as the object's fastest motion on its "
                   "grip asks for, 4 to 64, and 4 for a case")
      ->check(number_in(1, 1000));
  command->add_option("--order", options->engine.order, "of the real-time path: 1 implicit Euler, 2 implicit midpoint")
      ->check(CLI::IsMember({1, 2}))
      ->capture_default_str();
  command->add_option("--accuracy", options->engine.accuracy, "of the reference's integrator")
      ->check(number_in(1e-13, 1e-3))
      ->capture_default_str();
  command
      ->add_option(
          "--visual-hand", options->visual_hand,
          "play the hand that a user is shown beside the real-time path: the whole hand, or each finger that touches, "
          "stands still on the object; with --out also a trace, realtime/drawn_hand.csv")
      ->check(CLI::IsMember({"whole", "finger"}));
  command->add_option("--out", options->out, "folder for the recordings as CSV, one folder an engine");
  command->footer(
      "Examples:\n  handhold run scene.toml --out recordings\n  handhold run --case C01 --engine realtime\n"
      "  handhold run --trace pinch-57fps.json.lz --mesh mug.obj --material glass\n"
      "  handhold run --trace pinch-57fps.json.lz --mesh mug.obj --engine realtime --visual-hand whole --out drawn\n"
      "Exit code 1: a run did not get to its end (diverged, stalled, interrupted).");
  command->callback([options, &invocation] { execute(*options, invocation); });
}

}  // namespace handhold::reports
