// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mutants/kill.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <regex>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace handhold::mutants {
namespace {

struct Said {
  std::string output{};
  bool well{};  ///< exit code 0
};

/// Runs the program as another process, with the defect planted if one is named.
Said run(const std::string& program, const std::string& defect, const std::string& arguments) {
  const std::string command =
      fmt::format("HANDHOLD_CACHE=off HANDHOLD_DEFECT='{}' '{}' {} 2>&1", defect, program, arguments);
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("no process could be started: " + command);
  Said said;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    said.output.append(buffer.data(), count);
  said.well = pclose(pipe) == 0;
  return said;
}

Said play(const std::string& program, const std::string& defect, const std::vector<std::string>& cases) {
  return run(program, defect, fmt::format("--gates {}", fmt::join(cases, " ")));
}

Said test(const std::string& program, const std::string& defect, const std::string& filter) {
  return run(program, defect, fmt::format("--gtest_filter='{}'", filter));
}

/// What the cases measure without a defect; played once for all that ask the same.
const Gates& sound_gates(const std::string& program, const std::vector<std::string>& cases) {
  static std::map<std::vector<std::string>, Gates> known;
  const auto found = known.find(cases);
  if (found != known.end()) return found->second;
  return known[cases] = read_gates(play(program, "", cases).output);
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void ask_gates(const Defect& defect, const std::string& program, Fate& fate) {
  const Said said = play(program, defect.name, defect.cases);
  const Gates gates = read_gates(said.output);
  for (const auto& [place, sound] : sound_gates(program, defect.cases)) {
    const auto found = gates.find(place);
    if (found == gates.end()) {
      fate = {.killer = place + " is missing", .by_gate = true, .gates = fate.gates + 1, .changed = true};
      fate.margin = std::numeric_limits<double>::infinity();
      continue;
    }
    const GateLine& gate = found->second;
    fate.changed = fate.changed || !same(gate.value, sound.value) || !same(gate.measured, sound.measured);
    if (gate.holds) continue;
    ++fate.gates;
    const double over = std::isnan(gate.measured) || gate.limit == 0 ? std::numeric_limits<double>::infinity()
                                                                     : gate.measured / gate.limit;
    if (fate.by_gate && over <= fate.margin) continue;
    fate.killer = place;
    fate.by_gate = true;
    fate.margin = over;
  }
}

void ask_tests(const Defect& defect, const std::string& program, Fate& fate) {
  const Said said = test(program, defect.name, defect.tests);
  if (said.well) return;
  static const std::regex failed("\\[  FAILED  \\] ([\\w/.]+)");
  std::smatch match;
  fate.killer = std::regex_search(said.output, match, failed) ? match[1].str() : defect.tests + " (did not end)";
  fate.changed = true;
}

}  // namespace

std::string fault_of_sound(const Defect& defect, const std::string& program) {
  if (!defect.cases.empty()) {
    const Gates& gates = sound_gates(program, defect.cases);
    if (gates.empty()) return "its cases have no gate";
    for (const auto& [place, gate] : gates)
      if (!gate.holds) return place + " fails without the defect";
  }
  if (defect.tests.empty()) return "";
  static std::map<std::string, bool> known;
  if (!known.contains(defect.tests)) {
    const Said said = test(program, "", defect.tests);
    known[defect.tests] = said.well && said.output.find("[  PASSED  ] 0 tests") == std::string::npos;
  }
  return known[defect.tests] ? "" : defect.tests + ": no such test, or it fails without the defect";
}

Fate fate_of(const Defect& defect, const std::string& program) {
  Fate fate;
  if (!defect.cases.empty()) ask_gates(defect, program, fate);
  if (fate.killer.empty() && !defect.tests.empty()) ask_tests(defect, program, fate);
  return fate;
}

}  // namespace handhold::mutants
