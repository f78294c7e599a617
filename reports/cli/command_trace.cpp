// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/input/trace/trace_csv.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "cases/input/trace/trace_summary.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/progress.hpp"
#include "reports/data/text.hpp"
#include "reports/data/write_report.hpp"

namespace handhold::reports {
namespace {

struct TraceCommand {
  std::string input{}, output{};
};

Trace read(const std::string& path) {
  ProgressLine progress(ProgressLine::Elsewhere::silent);
  progress.step("reading " + path);
  return read_trace(path);
}

void info(const TraceCommand& command) { fmt::print("{}", to_text(summarize(read(command.input)))); }

void convert(const TraceCommand& command) {
  const Trace trace = read(command.input);
  for (const std::string& warning : trace.warnings) fmt::print("warning: {}\n", one_line(warning));
  write_file(command.output, to_csv(trace));
  fmt::print("{}: {} stamps, {} hand{}\n", command.output, trace.t.size(), trace.hands.size(),
             trace.hands.size() == 1 ? "" : "s");
}

}  // namespace

void add_trace(CLI::App& app, Invocation&) {
  CLI::App* command = app.add_subcommand("trace", "Look at a recording of hands, or turn it into handhold's own CSV");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n  handhold trace info pinch-57fps.json.lz\n  handhold trace convert pinch-57fps.json.lz pinch.csv");
  const auto options = std::make_shared<TraceCommand>();
  CLI::App* show = command->add_subcommand("info", "Print duration, rate, gaps, hands, pinches and what was repaired");
  show->add_option("file", options->input, "LeapJS .json or .json.lz, joints as JSON, or handhold's CSV")->required();
  show->footer("Examples:\n  handhold trace info pinch-57fps.json.lz\n  handhold trace info grasp.csv");
  show->callback([options] { info(*options); });
  CLI::App* turn = command->add_subcommand("convert", "Write the recording as handhold's CSV: metres, z up");
  turn->add_option("file", options->input, "LeapJS .json or .json.lz, joints as JSON, or handhold's CSV")->required();
  turn->add_option("out", options->output, "the CSV file to write")->required();
  turn->footer(
      "Examples:\n  handhold trace convert pinch-57fps.json.lz pinch.csv\n  handhold trace convert quest.json "
      "quest.csv");
  turn->callback([options] { convert(*options); });
}

}  // namespace handhold::reports
