// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>
#include <string>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/interrupt.hpp"
#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

std::string quoted(const std::string& argument) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-_./,:=+@%").find(c) != std::string_view::npos;
  };
  if (!argument.empty() && std::all_of(argument.begin(), argument.end(), plain)) return argument;
  std::string out = "'";
  for (const char c : argument) c == '\'' ? out += "'\\''" : out += c;
  return out + "'";
}

std::string command_line(int count, char** arguments) {
  std::string out = "handhold";
  for (int i = 1; i < count; ++i) out += " " + quoted(arguments[i]);
  return out;
}

int complain(const std::string& what, int exit_code) {
  std::fputs(fmt::format("handhold: error: {}\n", one_line(what)).c_str(), stderr);
  return exit_code;
}

/// "handhold trace info", as far as the words were understood.
std::string asked(const CLI::App& app) {
  const auto subcommands = app.get_subcommands();
  return app.get_name() + (subcommands.empty() ? "" : " " + asked(*subcommands.front()));
}

int run(int count, char** arguments) {
  Invocation invocation{command_line(count, arguments)};
  CLI::App app{"Judges physics-based hand-object contact: analytic cases, a reference engine, a real-time path.",
               "handhold"};
  app.require_subcommand(1);
  app.set_version_flag("--version", HANDHOLD_VERSION);
  app.footer(
      "Examples:\n  handhold suite                     run every case, write handhold-report/\n"
      "  handhold list                      what there is to run\n  handhold run --case C01            one case, in "
      "detail\n"
      "Exit codes: 0 all gates hold, 1 a gate failed, 2 wrong input, 3 a bug of ours.");
  add_list(app, invocation);
  add_suite(app, invocation);
  add_run(app, invocation);
  add_grasps(app, invocation);
  add_report(app, invocation);
  add_converge(app, invocation);
  add_voxelize(app, invocation);
  add_engines(app, invocation);
  add_export(app, invocation);
  add_judge(app, invocation);
  add_judge_log(app, invocation);
  add_baseline(app, invocation);
  add_merge(app, invocation);
  add_tables(app, invocation);
  add_trace(app, invocation);
  try {
    app.parse(count, arguments);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return complain(fmt::format("{} (see {} --help)", error.what(), asked(app)), exit_wrong_input);
  }
  return invocation.exit_code;
}

}  // namespace
}  // namespace handhold::reports

int main(int count, char** arguments) {
  using namespace handhold::reports;
  watch_interrupts();
  try {
    const int exit_code = run(count, arguments);
    if (std::fflush(stdout) != 0)
      return complain("standard output: cannot be written (is the disk full?)", exit_wrong_input);
    return exit_code;
  } catch (const handhold::InputError& error) {
    return complain(error.what(), exit_wrong_input);
  } catch (const std::system_error& error) {  // of fmt::print
    return complain(fmt::format("standard output: {} (is the disk full?)", error.what()), exit_wrong_input);
  } catch (const std::exception& error) {
    return complain(fmt::format("this is our bug, please report it with the command and its input: {}", error.what()),
                    exit_our_bug);
  } catch (...) {
    return complain("this is our bug, please report it with the command and its input", exit_our_bug);
  }
}
