// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "compare/engine/engines.hpp"
#include "compare/engine/process_engine.hpp"
#include "compare/judge/suite.hpp"
#include "compare/judge/verdict.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/interrupt.hpp"
#include "reports/cli/option_checks.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/provenance.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/baseline_file.hpp"
#include "reports/data/results_json.hpp"
#include "reports/data/table.hpp"
#include "reports/data/text.hpp"
#include "reports/data/write_report.hpp"

namespace handhold::reports {
namespace {

struct SuiteCommand {
  compare::SuiteOptions suite{};
  std::vector<std::string> engines{}, processes{}, levels{};
  bool no_order{}, no_variants{};
  std::string shard{}, baseline{};
  std::string out{"handhold-report"};
};

/// Those named, or all that have derived limits: what a suite gates.
std::vector<std::unique_ptr<compare::Engine>> engines_of(const SuiteCommand& command) {
  std::vector<std::unique_ptr<compare::Engine>> out;
  const bool all = command.engines.size() == 1 && command.engines.front() == "all";
  for (const std::string& name : command.engines.empty() || all ? compare::engine_names() : command.engines) {
    std::unique_ptr<compare::Engine> engine = compare::make_engine(name);
    const bool gated = engine->info(command.suite.engine).errs.kind != compare::ErrorModel::Kind::foreign;
    if (gated || !command.engines.empty()) out.push_back(std::move(engine));
  }
  for (const std::string& process : command.processes) out.push_back(compare::process_engine_from(process));
  return out;
}

/// "2/8".
compare::Shard shard_of(const std::string& text) {
  compare::Shard shard;
  int read = 0;
  const bool two = std::sscanf(text.c_str(), "%zu/%zu%n", &shard.index, &shard.of, &read) == 2;
  if (two && std::size_t(read) == text.size() && shard.index >= 1 && shard.index <= shard.of) return shard;
  throw InputError(
      fmt::format("--shard {}: is no part of a whole (write 2/8 for the second of eight)", one_line(text)));
}

Level level_of(const std::string& name) {
  return name == "L1" ? Level::rigid : name == "L2" ? Level::compliant : Level::printed;
}

/// What differs from the baseline; of a part of the suite only what that part holds.
std::vector<compare::Change> moved(const compare::Baseline& before, const compare::SuiteResult& result, bool whole) {
  std::vector<compare::Change> out = compare::changes(before, baseline_of(results_json(result), "this suite"));
  if (!whole) std::erase_if(out, [](const auto& change) { return change.movement == compare::Movement::gone; });
  return out;
}

/// True if what is missing was not asked for.
bool is_whole(const SuiteCommand& command) {
  return command.suite.ids.empty() && command.levels.empty() && command.engines.empty() && !command.no_variants &&
         command.shard.empty() && !command.suite.fail_fast;
}

compare::SuiteResult run(const SuiteCommand& command) {
  const std::vector<std::unique_ptr<compare::Engine>> owned = engines_of(command);
  std::vector<const compare::Engine*> engines;
  for (const auto& engine : owned) engines.push_back(engine.get());
  ProgressLine progress;
  return compare::run_suite(engines, command.suite, [&](const std::string& what, std::size_t done, std::size_t all) {
    if (!interrupted()) progress.step(fmt::format("[{}/{}] {}", done, all, what));
    return !interrupted();
  });
}

void execute(SuiteCommand command, Invocation& invocation) {
  check_report_folder(command.out);  // now, not after minutes of work
  if (command.no_order) command.suite.study_refinements.clear();
  command.suite.variants = !command.no_variants;
  for (const std::string& name : command.levels) command.suite.levels.push_back(level_of(name));
  if (!command.shard.empty()) command.suite.shard = shard_of(command.shard);
  const compare::Baseline before =
      command.baseline.empty() ? compare::Baseline{} : read_baseline(command.baseline).gates;
  command.suite.stop = interrupted;
  command.suite.keep_recordings = true;
  compare::SuiteResult result = run(command);
  result.provenance = provenance(command.suite);
  result.occasion = occasion(invocation.command_line);
  if (!command.baseline.empty()) result.moved = moved(before, result, is_whole(command) && !result.interrupted);
  const compare::Count n = compare::count(result);
  const bool empty_part = result.shard && result.cases.empty() && !result.interrupted;  // more parts than runs
  invocation.exit_code = compare::passed(result) || empty_part ? exit_good : exit_gate_failed;
  if (result.moved && !result.moved->empty()) invocation.exit_code = exit_gate_failed;
  const bool judged = n.gates + n.graded > 0 || empty_part;
  if (judged) write_report(result, command.out);  // before its table is printed: a closed pipe loses nothing
  fmt::print("{}", text_table(result, {may_colour(1)}));
  if (!judged) return;  // interrupted at once: an earlier report is worth more
  say(fmt::format("{}: {}\n", result.interrupted ? "partial report" : "report",
                  (std::filesystem::path(command.out) / "index.html").lexically_normal().string()));
}

}  // namespace

void add_suite(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("suite", "Play the analytic cases with every engine, judge them, and write a report");
  const auto options = std::make_shared<SuiteCommand>();
  compare::EngineOptions& engine = options->suite.engine;
  command->add_option("--only", options->suite.ids, "cases to run, e.g. C01,D02 (default: all)")->delimiter(',');
  command->add_option("--level", options->levels, "levels to run, e.g. L1,L2 (default: all)")
      ->delimiter(',')
      ->check(CLI::IsMember({"L1", "L2", "L3"}));
  command
      ->add_option("--engines", options->engines, "engines to judge, or all (default: those whose limits are derived)")
      ->delimiter(',');
  command->add_option("--engine", options->processes,
                      "a process as one more engine: NAME=COMMAND, e.g. \"mine=python3 mine.py {problem} {out}\"");
  command->add_option("--out", options->out, "folder of the report; replaced as a whole")->capture_default_str();
  command->add_option("--threads", options->suite.threads, "runs side by side; 0: one a core")
      ->check(number_in(0, 1024))
      ->capture_default_str();
  command->add_option("--shard", options->shard, "part of the runs to play, e.g. 2/8: the second of eight (see merge)");
  command->add_option("--baseline", options->baseline,
                      "say what moved since this baseline was written, and fail if anything did (see baseline)");
  command->add_option("--frame-rate", engine.frame_rate, "frames a second [Hz]")
      ->check(number_in(1, 1e4))
      ->capture_default_str();
  command->add_option("--substeps", engine.substeps, "steps a frame of engines with a fixed step")
      ->check(number_in(1, 1000))
      ->capture_default_str();
  command->add_option("--accuracy", engine.accuracy, "of engines that control their error")
      ->check(number_in(1e-13, 1e-3))
      ->capture_default_str();
  command->add_flag("--no-order", options->no_order, "skip the studies of the order of accuracy")
      ->disable_flag_override();
  command->add_flag("--no-variants", options->no_variants, "skip the runs that are turned, mirrored and reordered")
      ->disable_flag_override();
  command->add_flag("--fail-fast", options->suite.fail_fast, "stop at the first gate that fails")
      ->disable_flag_override();
  command->footer(
      "Examples:\n  handhold suite\n  handhold suite --only C01,D02 --out report\n  handhold suite --level L1 "
      "--engines "
      "rigid\n  handhold suite --substeps 16 --no-order\n  handhold suite --shard 2/8 --out part-2\n  handhold suite "
      "--baseline "
      "baseline.json\n"
      "Ctrl-C ends it; the runs judged until then are written, and the report says that it is partial.");
  command->callback([options, &invocation] { execute(*options, invocation); });
}

}  // namespace handhold::reports
