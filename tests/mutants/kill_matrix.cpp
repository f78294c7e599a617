// SPDX-License-Identifier: GPL-3.0-or-later
// Plants one defect after another and says which gate or test notices: `./dev mutants`.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/mutants/defects.hpp"
#include "tests/mutants/gates.hpp"
#include "tests/mutants/kill.hpp"
#include "tests/mutants/places.hpp"

namespace handhold::mutants {
namespace {

struct Row {
  const Defect* defect{};
  Fate fate{};
  std::string place{};
};

std::string margin_text(const Fate& fate) {
  if (!fate.by_gate) return "";
  if (std::isinf(fate.margin)) return "any";
  return fmt::format("{:.3g}", fate.margin);
}

void print(const Row& row) {
  const Fate& f = row.fate;
  fmt::print("{:5}  {:32} {:40} {}{}{}\n", f.killer.empty() ? "LIVES" : "dies", row.defect->name, row.place, f.killer,
             f.by_gate ? fmt::format(", {} times its limit", margin_text(f)) : "",
             f.changed ? "" : ", and no number changed");
  std::fflush(stdout);
}

nlohmann::json json_of(const std::vector<Row>& rows) {
  nlohmann::json out = nlohmann::json::array();
  for (const Row& row : rows) {
    nlohmann::json one{{"name", row.defect->name},   {"what", row.defect->what},
                       {"place", row.place},         {"lives", row.fate.killer.empty()},
                       {"killer", row.fate.killer},  {"by", row.fate.by_gate ? "gate" : "test"},
                       {"changed", row.fate.changed}};
    if (row.fate.by_gate) one["gates"] = row.fate.gates;
    if (row.fate.by_gate && std::isfinite(row.fate.margin)) one["margin"] = row.fate.margin;
    out.push_back(one);
  }
  return {{"defects", out}};
}

std::string document(const std::vector<Row>& rows) {
  const auto dead = std::ranges::count_if(rows, [](const Row& r) { return !r.fate.killer.empty(); });
  const auto by_gate = std::ranges::count_if(rows, [](const Row& r) { return r.fate.by_gate; });
  std::string out = fmt::format(
      "# Kill matrix\n\nWritten by `./dev mutants --write`. Each row is a defect that is planted by hand (`DEFECT` in "
      "the "
      "sources, `cases/model/defect.hpp`) and\nwhat notices it: a gate of the suite if any does, else a test. The "
      "margin is the greatest error over its limit: limits would have to be\nthat many times wider for the defect to "
      "live; \"any\": no limit would help, the number is not there or is a yes or no.\n\n{} defects, {} die, {} of "
      "them "
      "by a gate.\n\n| defect | what is wrong | planted in | killer | gates | margin |\n|---|---|---|---|---|---|\n",
      rows.size(), dead, by_gate);
  for (const Row& r : rows) {
    const std::string file = r.place.substr(0, r.place.find(':'));
    out += fmt::format("| {} | {} | {} | {} | {} | {} |\n", r.defect->name, r.defect->what, file,
                       r.fate.killer.empty() ? "**lives**" : r.fate.killer,
                       r.fate.by_gate ? std::to_string(r.fate.gates) : "", margin_text(r.fate));
  }
  return out;
}

/// Every defect of the table is planted somewhere, and every planted one stands in the table.
bool table_is_whole(const std::map<std::string, std::string>& where) {
  bool whole = true;
  const std::vector<Defect>& all = all_defects();
  for (const Defect& d : all)
    if (!where.contains(d.name)) whole = (fmt::print("{}: is planted nowhere\n", d.name), false);
  for (const auto& [name, place] : where)
    if (std::ranges::find(all, name, &Defect::name) == all.end())
      whole = (fmt::print("{}: {} is not in tests/mutants/defects.cpp\n", place, name), false);
  return whole;
}

struct Wish {
  std::vector<std::string> names{};
  std::string json{}, document{};
  bool quick{false};  ///< only those that tests alone see: seconds
};

bool wanted(const Defect& d, const Wish& wish) {
  if (wish.quick) return d.cases.empty();
  return wish.names.empty() || std::ranges::find(wish.names, d.name) != wish.names.end();
}

int run_matrix(const Wish& wish, const std::string& program) {
  const std::map<std::string, std::string> where = places(HANDHOLD_SOURCES);
  if (!table_is_whole(where)) return 1;
  for (const std::string& name : wish.names)
    if (!where.contains(name))
      return fmt::print(stderr, "{}: no such defect (see tests/mutants/defects.cpp)\n", name), 2;
  std::vector<Row> rows;
  int lives = 0;
  for (const Defect& d : all_defects()) {
    if (!wanted(d, wish)) continue;
    if (const std::string fault = fault_of_sound(d, program); !fault.empty()) {
      fmt::print("{}: {}\n", d.name, fault);
      return 1;
    }
    rows.push_back({&d, fate_of(d, program), where.at(d.name)});
    lives += rows.back().fate.killer.empty();
    print(rows.back());
  }
  fmt::print("{} defects, {} live\n", rows.size(), lives);
  if (!wish.json.empty()) std::ofstream(wish.json) << json_of(rows).dump(1) << "\n";
  if (!wish.document.empty()) std::ofstream(wish.document) << document(rows);
  return lives == 0 && !rows.empty() ? 0 : 1;
}

}  // namespace
}  // namespace handhold::mutants

int main(int argc, char** argv) {
  namespace mutants = handhold::mutants;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && arguments[0] == "--gates") {
    std::fputs(mutants::played({arguments.begin() + 1, arguments.end()}).c_str(), stdout);
    return 0;
  }
  if (!arguments.empty() && arguments[0].starts_with("--gtest")) {
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
  }
  mutants::Wish wish;
  for (const std::string& a : arguments) {
    if (a == "--quick")
      wish.quick = true;
    else if (a.starts_with("--json="))
      wish.json = a.substr(std::strlen("--json="));
    else if (a.starts_with("--document="))
      wish.document = a.substr(std::strlen("--document="));
    else
      wish.names.push_back(a);
  }
  return mutants::run_matrix(wish, std::filesystem::canonical("/proc/self/exe").string());
}
