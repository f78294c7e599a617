#include <cctype>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <variant>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/catalogue/case.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/mjcf.hpp"
#include "compare/engine/problem_json.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/option_checks.hpp"

namespace handhold::reports {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  std::string id{};
  std::string out{"problems"};
  double step{1.0 / 360};
  int frame_every{4};
};

const catalogue::Case& case_of(const std::string& id) {
  std::string ids;
  for (const catalogue::Case& c : catalogue::all_cases()) {
    if (c.id == id) return c;
    if (c.level == Level::rigid) ids += (ids.empty() ? "" : ", ") + c.id;
  }
  throw InputError(fmt::format("case '{}': there is none (of level L1 there are: {})", id, ids.empty() ? "none" : ids));
}

/// A run's name as that of a folder.
std::string folder_of(const catalogue::Run& run) {
  std::string name = run.name + (run.variant.empty() ? "" : "-" + run.variant);
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = '_';
  return name;
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream out(file);
  if (!(out << text << std::flush))
    throw InputError(fmt::format("{}: cannot be written (free space, or give another folder)", file.string()));
}

void export_case(const ExportOptions& options) {
  const catalogue::Case& c = case_of(options.id);
  if (c.level != Level::rigid)
    throw InputError(fmt::format("case '{}': is of level {}, and files hold rigid problems (take one of L1)", c.id,
                                 to_string(c.level)));
  for (const catalogue::Run& run : c.runs) {
    const fs::path folder = fs::path(options.out) / c.id / folder_of(run);
    const compare::SampledProblem problem = compare::sample(std::get<RigidProblem>(run.problem()),
                                                            c.id + " " + run.name, options.step, options.frame_every);
    std::error_code failed;
    fs::create_directories(folder, failed);
    write(folder / "problem.json", compare::problem_json(problem));
    write(folder / "problem.xml", compare::mjcf(problem));
    fmt::print("{}\n", (folder / "problem.json").string());
  }
}

}  // namespace

void add_export(CLI::App& app, Invocation&) {
  CLI::App* command = app.add_subcommand("export", "Write the problems of a case for engines of others");
  const auto options = std::make_shared<ExportOptions>();
  command->add_option("case", options->id, "of level L1")->required();
  command->add_option("--out", options->out, "folder; CASE/RUN is made in it")->capture_default_str();
  command->add_option("--step", options->step, "of the engine [s]")->check(number_in(1e-6, 1))->capture_default_str();
  command->add_option("--frame-every", options->frame_every, "steps from one frame of the answer to the next")
      ->check(number_in(1, 1e6))
      ->capture_default_str();
  command->footer("Examples:\n  handhold export L1-C03\n  handhold export L1-D01 --out problems --step 0.001");
  command->callback([options] { export_case(*options); });
}

}  // namespace handhold::reports
