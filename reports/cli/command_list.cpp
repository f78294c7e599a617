// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/catalogue/case.hpp"
#include "cases/geometry/shapes.hpp"
#include "cases/input/scene/materials.hpp"
#include "compare/engine/engines.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/terminal.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

struct ListOptions {
  bool engines{}, materials{}, shapes{};
};

void print_cases() {
  for (const catalogue::Case& c : catalogue::all_cases()) {
    say(fmt::format("{}  {}  ({})\n", c.id, c.title, to_string(c.level)));
    for (const catalogue::Run& run : c.runs) {
      std::string quantities;
      if (!run.variant.empty()) continue;
      for (const catalogue::Claim& claim : run.claims) quantities += (quantities.empty() ? "" : ", ") + claim.quantity;
      say(fmt::format("     {}: {}\n", run.name, quantities));
    }
  }
}

void print_engines() {
  for (const std::string& name : compare::engine_names()) {
    const compare::EngineInfo info = compare::make_engine(name)->info({});
    std::string levels;
    for (const Level level : info.levels) levels += (levels.empty() ? "" : ", ") + std::string(to_string(level));
    const bool gated = info.errs.kind != compare::ErrorModel::Kind::foreign;
    say(fmt::format("{}{}{}\n", left(name, 18), left(levels, 8), gated ? "gated: its limits are derived" : "graded"));
  }
}

std::string_view to_string(Evidence evidence) {
  return evidence == Evidence::published ? "published" : evidence == Evidence::unverified ? "unverified" : "assumed";
}

void print_materials() {
  say(fmt::format("{}{}{}{}  {}\n", left("material", 18), right("mu_static", 10), right("mu_dynamic", 12),
                  right("kg/m³", 8), "source of mu_static against skin"));
  for (const Material& m : materials()) {
    say(fmt::format("{}{}{}{}  {}: {}\n", left(m.name, 18), right(number(m.friction().mu_static, 3), 10),
                    right(number(m.friction().mu_dynamic, 3), 12), right(number(m.density, 4), 8),
                    to_string(m.evidence), m.source));
  }
}

void print_shapes() {
  for (const ShapeKind& kind : shape_kinds()) {
    say(fmt::format("{}  {}\n", left(kind.name, 16), kind.meaning));
    for (const ShapeParameter& p : kind.parameters)
      say(fmt::format("  {}{}  {}\n", left(p.name, 20), right(number(p.value, 4), 8), p.meaning));
  }
}

void list(const ListOptions& options) {
  if (options.engines) print_engines();
  if (options.materials) print_materials();
  if (options.shapes) print_shapes();
  if (!options.engines && !options.materials && !options.shapes) print_cases();
}

}  // namespace

void add_list(CLI::App& app, Invocation&) {
  CLI::App* command =
      app.add_subcommand("list", "Print the cases with their runs and quantities, or what else there is");
  const auto options = std::make_shared<ListOptions>();
  command->add_flag("--engines", options->engines, "the engines of this build")->disable_flag_override();
  command->add_flag("--materials", options->materials, "materials with friction against skin and density")
      ->disable_flag_override();
  command->add_flag("--shapes", options->shapes, "procedural shapes and their parameters")->disable_flag_override();
  command->footer("Examples:\n  handhold list\n  handhold list --materials\n  handhold list --shapes --engines");
  command->callback([options] { list(*options); });
}

}  // namespace handhold::reports
