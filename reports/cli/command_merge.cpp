// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/cli/commands.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/merge_shards.hpp"
#include "reports/data/write_report.hpp"

namespace handhold::reports {
namespace {

struct MergeCommand {
  std::vector<std::string> parts{};
  std::string out{"handhold-report"};
};

int execute(const MergeCommand& command) {
  check_report_folder(command.out);
  std::vector<NamedReport> parts;
  for (const std::string& given : command.parts) parts.push_back(read_named_report(given));
  const StoredReport report = merged_shards(std::move(parts));
  write_stored_report(report, command.out);
  const auto verdict = nlohmann::json::parse(report.results)["verdict"];
  say(fmt::format("{}\nreport: {}\n", verdict["sentence"].get<std::string>(),
                  (std::filesystem::path(command.out) / "index.html").lexically_normal().string()));
  return verdict["passed"].get<bool>() ? exit_good : exit_gate_failed;
}

}  // namespace

void add_merge(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("merge", "Make one report of the parts that suite --shard wrote");
  const auto options = std::make_shared<MergeCommand>();
  command->add_option("PARTS", options->parts, "the folders of all parts, in any order")->required();
  command->add_option("--out", options->out, "folder of the report; replaced as a whole")->capture_default_str();
  command->footer(
      "Examples:\n  handhold suite --shard 1/2 --out part-1\n  handhold suite --shard 2/2 --out part-2\n"
      "  handhold merge part-1 part-2 --out report\n"
      "results.json has the bytes that one process would have written. Exit code: that of the suite.");
  command->callback([options, &invocation] { invocation.exit_code = execute(*options); });
}

}  // namespace handhold::reports
