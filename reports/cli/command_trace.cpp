// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/input/trace/trace_csv.hpp"
#include "cases/input/trace/trace_reader.hpp"
#include "cases/input/trace/trace_summary.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/option_checks.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/text.hpp"
#include "reports/data/write_report.hpp"

namespace handhold::reports {
namespace {

struct TraceCommand {
  std::string input{}, output{};
  TraceReadOptions reading{};
};

Trace read(const TraceCommand& command) {
  ProgressLine progress(ProgressLine::Elsewhere::silent);
  progress.step("reading " + command.input);
  return read_trace(command.input, command.reading);
}

void info(const TraceCommand& command) { say(to_text(summarize(read(command)))); }

void convert(const TraceCommand& command) {
  const Trace trace = read(command);
  for (const std::string& warning : trace.warnings) say(fmt::format("warning: {}\n", one_line(warning)));
  write_file(command.output, to_csv(trace));
  say(fmt::format("{}: {} stamps, {} hand{}\n", command.output, trace.t.size(), trace.hands.size(),
                  trace.hands.size() == 1 ? "" : "s"));
}

void add_reading(CLI::App& command, TraceCommand& options) {
  command
      .add_option("file", options.input,
                  "LeapJS .json or .json.lz, joints as JSON or as CSV with a column a coordinate, or handhold's CSV")
      ->required();
  command.add_option("--scale", options.reading.scale, "multiplies all lengths: 0.001 if the file is in millimetres")
      ->check(number_in(1e-9, 1e9));
  command
      .add_option("--time-scale", options.reading.time_scale, "multiplies all times: 0.001 if they are milliseconds")
      ->check(number_in(1e-12, 1e12));
  add_trace_flags(command, options.reading);
}

}  // namespace

void add_trace_flags(CLI::App& command, TraceReadOptions& reading) {
  command.add_flag("--repair", reading.repair, "bridge glitches of one to three frames of the recorded hand")
      ->disable_flag_override();
  command.add_flag("--trust", reading.trust, "believe a recorded hand whose size or rate cannot be a hand's")
      ->disable_flag_override();
}

void add_trace(CLI::App& app, Invocation&) {
  CLI::App* command = app.add_subcommand("trace", "Look at a recording of hands, or turn it into handhold's own CSV");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n  handhold trace info pinch-57fps.json.lz\n  handhold trace convert pinch-57fps.json.lz pinch.csv");
  const auto options = std::make_shared<TraceCommand>();
  CLI::App* show = command->add_subcommand("info", "Print duration, rate, gaps, hands, pinches and what was repaired");
  add_reading(*show, *options);
  show->footer("Examples:\n  handhold trace info pinch-57fps.json.lz\n  handhold trace info grasp.csv");
  show->callback([options] { info(*options); });
  CLI::App* turn = command->add_subcommand("convert", "Write the recording as handhold's CSV: metres, z up");
  add_reading(*turn, *options);
  turn->add_option("out", options->output, "the CSV file to write")->required();
  turn->footer(
      "Examples:\n  handhold trace convert pinch-57fps.json.lz pinch.csv\n  handhold trace convert quest.json "
      "quest.csv");
  turn->callback([options] { convert(*options); });
}

}  // namespace handhold::reports
