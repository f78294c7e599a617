// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "reports/cli/commands.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/merge_results.hpp"
#include "reports/data/write_report.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

struct ReportCommand {
  std::vector<std::string> results{};
  std::string out{"handhold-page"};
};

void execute(const ReportCommand& command) {
  check_report_folder(command.out);
  std::vector<NamedReport> parts;
  for (const std::string& given : command.results) parts.push_back(read_named_report(given));
  write_stored_report(merged(std::move(parts)), command.out);
  say(fmt::format("report: {}\n", (fs::path(command.out) / "index.html").lexically_normal().string()));
}

}  // namespace

void add_report(CLI::App& app, Invocation&) {
  CLI::App* command =
      app.add_subcommand("report", "Make the report's page again from stored results, of several runs too");
  const auto options = std::make_shared<ReportCommand>();
  command
      ->add_option("RESULTS", options->results, "results.json, or folders of reports; recordings beside them are used")
      ->required();
  command->add_option("--out", options->out, "folder of the new report; replaced as a whole")->capture_default_str();
  command->footer(
      "Examples:\n  handhold report handhold-report --out page\n"
      "  handhold report before/results.json after/results.json --out both");
  command->callback([options] { execute(*options); });
}

}  // namespace handhold::reports
