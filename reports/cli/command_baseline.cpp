// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/baseline_file.hpp"
#include "reports/data/stored_report.hpp"
#include "reports/data/text.hpp"
#include "reports/data/write_report.hpp"

namespace handhold::reports {
namespace {

struct BaselineCommand {
  std::string file{}, from{"handhold-report"}, reason{};
};

compare::Baseline gates_of_report(const std::string& place) {
  const NamedReport report = read_named_report(place);
  return baseline_of(report.report.results, report.name);
}

void check(const BaselineCommand& command, Invocation& invocation) {
  const std::vector<compare::Change> changes =
      compare::changes(read_baseline(command.file).gates, gates_of_report(command.from));
  for (const compare::Change& change : changes) say(fmt::format("  {}\n", one_line(compare::sentence(change))));
  say(fmt::format("{}: {}\n", command.file, compare::summary(changes)));
  if (changes.empty()) return;
  say(fmt::format("if that is meant: handhold baseline update {} --from {} --reason \"why\"\n", command.file,
                  command.from));
  invocation.exit_code = exit_gate_failed;
}

/// A report without studies of the order says nothing about them: what is known of them stays.
void keep_orders(const compare::Baseline& known, compare::Baseline& now) {
  if (std::any_of(now.begin(), now.end(), [](const auto& gate) { return gate.first.order; })) return;
  for (const auto& [name, measured] : known)
    if (name.order) now.emplace(name, measured);
}

void update(const BaselineCommand& command) {
  if (one_line(command.reason).size() < 10)
    throw InputError(fmt::format("--reason '{}': must say why the figures move (a sentence)", command.reason));
  BaselineFile file;
  if (std::filesystem::exists(command.file)) file = read_baseline(command.file);
  compare::Baseline now = gates_of_report(command.from);
  const std::string summary = compare::summary(compare::changes(file.gates, now));
  if (summary == compare::summary({})) return say(fmt::format("{}: nothing moved, left as it is\n", command.file));
  keep_orders(file.gates, now);
  file.gates = std::move(now);
  file.reasons.push_back(fmt::format("{} ({})", one_line(command.reason), summary));
  write_file(command.file, to_json(file));
  say(fmt::format("{}: written; {}\n", command.file, summary));
}

CLI::App* add_part(CLI::App& app, BaselineCommand& options, const std::string& name, const std::string& what) {
  CLI::App* part = app.add_subcommand(name, what);
  part->add_option("FILE", options.file, "the baseline, kept in your repository")->required();
  part->add_option("--from", options.from, "the report of a suite")->capture_default_str();
  return part;
}

}  // namespace

void add_baseline(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("baseline", "Say what moved since somebody last looked, gate by gate");
  command->require_subcommand(1);
  const auto options = std::make_shared<BaselineCommand>();
  CLI::App* part = add_part(*command, *options, "check", "Fail if a gate is gone or new, or its value or limit moved");
  part->footer(
      "Examples:\n  handhold suite --out report\n  handhold baseline check baseline.json --from report\n"
      "A value that differs by less than 1e-9 has not moved. Exit code: 1 if anything moved, also towards the truth.");
  part->callback([options, &invocation] { check(*options, invocation); });
  part = add_part(*command, *options, "update", "Write it anew, with the reason, which is kept beside the values");
  part->add_option("--reason", options->reason, "why the figures move")->required();
  part->footer(
      "Examples:\n  handhold baseline update baseline.json --from report --reason \"the first one\"\n"
      "The values are a memory, not truth: look at what moved (baseline check) before you write it down.");
  part->callback([options] { update(*options); });
}

}  // namespace handhold::reports
