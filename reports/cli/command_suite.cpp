#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "compare/engine/engines.hpp"
#include "compare/judge/suite.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/interrupt.hpp"
#include "reports/cli/option_checks.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/provenance.hpp"
#include "reports/data/placed_gate.hpp"
#include "reports/data/table.hpp"
#include "reports/data/write_report.hpp"

namespace handhold::reports {
namespace {

struct SuiteCommand {
  compare::SuiteOptions suite{};
  bool no_order{};
  std::string out{"handhold-report"};
};

compare::SuiteResult run(compare::SuiteOptions options) {
  options.stop = interrupted;
  const std::unique_ptr<compare::Engine> reference = compare::make_engine("reference");
  const std::unique_ptr<compare::Engine> realtime = compare::make_engine("realtime");
  ProgressLine progress;
  return compare::run_suite(*reference, *realtime, options, [&](const std::string& what) {
    if (!interrupted()) progress.step(what);
    return !interrupted();
  });
}

void execute(SuiteCommand command, Invocation& invocation) {
  check_report_folder(command.out);  // now, not after minutes of work
  if (command.no_order) command.suite.study_refinements.clear();
  compare::SuiteResult result = run(command.suite);
  result.provenance.merge(provenance(command.suite));
  result.provenance["command"] = invocation.command_line;
  fmt::print("{}", text_table(result, {may_colour(1)}));
  invocation.exit_code = compare::passed(result) ? exit_good : exit_gate_failed;
  if (placed_gates(result).empty()) return;  // interrupted at once: an earlier report is worth more
  write_report(result, command.out);
  fmt::print("{}: {}\n", result.interrupted ? "partial report" : "report",
             (std::filesystem::path(command.out) / "index.html").lexically_normal().string());
}

}  // namespace

void add_suite(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("suite", "Run the analytic cases through both engines, judge them, and write a report");
  const auto options = std::make_shared<SuiteCommand>();
  compare::EngineOptions& engine = options->suite.engine;
  command->add_option("--only", options->suite.ids, "cases to run, e.g. C01,D02 (default: all)")->delimiter(',');
  command->add_option("--out", options->out, "folder of the report; replaced as a whole")->capture_default_str();
  command->add_option("--frame-rate", engine.frame_rate, "frames a second [Hz]")
      ->check(number_in(1, 1e4))
      ->capture_default_str();
  command->add_option("--substeps", engine.substeps, "sub-steps a frame of the real-time path")
      ->check(number_in(1, 1000))
      ->capture_default_str();
  command->add_option("--accuracy", engine.accuracy, "of the reference's integrator")
      ->check(number_in(1e-13, 1e-3))
      ->capture_default_str();
  command->add_flag("--no-order", options->no_order, "skip the studies of the order of accuracy")
      ->disable_flag_override();
  command->footer(
      "Examples:\n  handhold suite\n  handhold suite --only C01,D02 --out report\n  handhold suite --substeps 16 "
      "--no-order\n"
      "Ctrl-C ends it; the runs judged until then are written, and the report says that it is partial.");
  command->callback([options, &invocation] { execute(*options, invocation); });
}

}  // namespace handhold::reports
