// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "compare/engine/engines.hpp"
#include "compare/engine/process_engine.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

struct EnginesOptions {
  std::string command{};
  double time_limit{60};
};

void print_engines() {
  for (const std::string& name : compare::engine_names()) say(fmt::format("{}here\n", left(name, 18)));
  for (const std::string& name : compare::npm_engine_names())
    if (!compare::npm_engine_is_installed(name))
      say(fmt::format("{}not installed (./dev engines; HANDHOLD_ENGINES names another folder)\n", left(name, 18)));
}

void check(const EnginesOptions& options, Invocation& invocation) {
  const std::vector<std::string> missing =
      compare::what_is_missing({.command = options.command, .time_limit = options.time_limit});
  for (const std::string& sentence : missing) say(fmt::format("{}\n", one_line(sentence)));
  if (missing.empty()) say("nothing is missing: it played a block that slides and one that is pressed\n");
  if (!missing.empty()) invocation.exit_code = exit_gate_failed;
}

}  // namespace

void add_engines(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("engines", "Say which engines there are, or what a command lacks to be one");
  command->footer("Examples:\n  handhold engines\n  handhold engines check \"python3 mine.py {problem} {out}\"");
  command->callback([command] {
    if (command->get_subcommands().empty()) print_engines();
  });
  CLI::App* checked = command->add_subcommand("check", "Give a command two small problems; say what is missing");
  const auto options = std::make_shared<EnginesOptions>();
  checked->add_option("command", options->command, "e.g. \"python3 mine.py {problem} {out}\"")->required();
  checked->add_option("--time-limit", options->time_limit, "of the command [s]")->capture_default_str();
  checked->footer("Example:\n  handhold engines check \"python3 mine.py {problem} {out}\"");
  checked->callback([options, &invocation] { check(*options, invocation); });
}

}  // namespace handhold::reports
