// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace handhold {
struct TraceReadOptions;
}

/// The subcommands of the program `handhold`. Each function adds one to `app`; its work runs while `app` parses.
namespace handhold::reports {

enum Exit { exit_good = 0, exit_gate_failed = 1, exit_wrong_input = 2, exit_our_bug = 3 };

/// What a command is given beside its options, and what it hands back.
struct Invocation {
  std::string command_line{};  ///< as typed, quoted for a shell
  int exit_code{exit_good};
};

void add_baseline(CLI::App& app, Invocation& invocation);
void add_list(CLI::App& app, Invocation& invocation);
void add_suite(CLI::App& app, Invocation& invocation);
void add_report(CLI::App& app, Invocation& invocation);
void add_run(CLI::App& app, Invocation& invocation);
void add_grasps(CLI::App& app, Invocation& invocation);
void add_voxelize(CLI::App& app, Invocation& invocation);
void add_converge(CLI::App& app, Invocation& invocation);
void add_engines(CLI::App& app, Invocation& invocation);
void add_export(CLI::App& app, Invocation& invocation);
void add_judge(CLI::App& app, Invocation& invocation);
void add_judge_log(CLI::App& app, Invocation& invocation);
void add_merge(CLI::App& app, Invocation& invocation);
void add_tables(CLI::App& app, Invocation& invocation);
void add_trace(CLI::App& app, Invocation& invocation);

/// --repair and --trust, for every command that reads a recorded hand.
void add_trace_flags(CLI::App& command, TraceReadOptions& reading);

}  // namespace handhold::reports
