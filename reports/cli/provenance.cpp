// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/provenance.hpp"

#include <array>
#include <ctime>
#include <fstream>

#include <Eigen/Core>
#include <fmt/format.h>
#include <sys/utsname.h>

#include "reports/data/text.hpp"

namespace handhold::reports {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  }
  return "unknown";
}

std::string system_name() {
  utsname name{};
  return ::uname(&name) == 0 ? fmt::format("{} {} {}", name.sysname, name.release, name.machine) : "unknown";
}

std::string now_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  std::array<char, 32> text{};
  ::gmtime_r(&now, &utc);
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S UTC", &utc)};
}

std::string substeps_text(const std::vector<int>& substeps) {
  std::string out;
  for (const int n : substeps) out += (out.empty() ? "" : ", ") + std::to_string(n);
  return out.empty() ? "none" : out;
}

}  // namespace

std::map<std::string, std::string> provenance(const compare::SuiteOptions& options) {
  return {{"version", HANDHOLD_VERSION},
          {"compiler", "g++ " __VERSION__},
          {"build", HANDHOLD_BUILD},
          {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
          {"refinements of order studies", substeps_text(options.study_refinements)}};
}

std::map<std::string, std::string> occasion(const std::string& command_line) {
  return {{"processor", one_line(processor())},
          {"system", one_line(system_name())},
          {"finished", now_utc()},
          {"command", command_line}};
}

}  // namespace handhold::reports
