// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/catalogue/case.hpp"
#include "cases/input/text_file.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/case_tables.hpp"
#include "reports/data/write_report.hpp"

namespace handhold::reports {
namespace {

struct TablesCommand {
  std::vector<std::string> documents{};
  std::string results{};
};

void write_tables(const TablesCommand& command) {
  const std::vector<CaseRow> rows = case_rows(read_text_file(command.results), command.results);
  for (const std::string& document : command.documents) {
    write_file(document, with_tables(read_text_file(document), rows, document));
    say(fmt::format("{}: written\n", document));
  }
}

void check_tables(const TablesCommand& command, Invocation& invocation) {
  const std::vector<CaseRow> rows = case_rows(catalogue::all_cases());
  for (const std::string& document : command.documents) {
    const std::vector<std::string> stale = stale_rows(read_text_file(document), rows, document);
    for (const std::string& sentence : stale) say(fmt::format("{}\n", sentence));
    if (stale.empty()) say(fmt::format("{}: its tables say what the catalogue says\n", document));
    if (!stale.empty()) invocation.exit_code = exit_gate_failed;
  }
  if (invocation.exit_code != exit_good) say("write them anew: handhold tables DOCUMENT --from results.json\n");
}

}  // namespace

void add_tables(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand(
      "tables", "Write the tables of cases in documents from a suite's results, or check that they are up to date");
  const auto options = std::make_shared<TablesCommand>();
  command
      ->add_option("documents", options->documents, "with <!-- table: cases L1 --> and <!-- end --> round each table")
      ->required();
  command->add_option("--from", options->results,
                      "the results.json of a whole suite; without it nothing is written, the rows are checked");
  command->footer(
      "Examples:\n  handhold tables docs/cases.md --from handhold-report/results.json\n  handhold tables docs/cases.md "
      "docs/paper.md\n"
      "The check compares all but the figures, which depend on compiler and machine; exit code 1 if a row is out of "
      "date.");
  command->callback([options, &invocation] {
    options->results.empty() ? check_tables(*options, invocation) : write_tables(*options);
  });
}

}  // namespace handhold::reports
