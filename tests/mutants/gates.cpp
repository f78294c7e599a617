// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/mutants/gates.hpp"

#include <cstdlib>
#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "compare/engine/engines.hpp"
#include "compare/judge/suite.hpp"

namespace handhold::mutants {

std::string played(const std::vector<std::string>& cases) {
  std::vector<std::unique_ptr<compare::Engine>> owned;
  std::vector<const compare::Engine*> engines;
  for (const std::string& name : compare::engine_names()) {
    owned.push_back(compare::make_engine(name));
    if (owned.back()->info({}).errs.kind != compare::ErrorModel::Kind::foreign) engines.push_back(owned.back().get());
  }
  const compare::SuiteResult result =
      compare::run_suite(engines, {.ids = cases, .study_refinements = {}, .variants = false, .threads = 1});
  std::string lines;
  for (const compare::CaseResult& of_case : result.cases)
    for (const compare::RunResult& run : of_case.runs)
      for (const compare::ClaimResult& claim : run.claims)
        for (const compare::Judgement& j : claim.judgements) {
          if (!j.gate) continue;
          lines += fmt::format("{}/{}: {}\t{}\t{}\t{}\t{}\n", of_case.id, run.name, j.gate->quantity, j.value,
                               j.gate->measured, j.gate->limit, int(j.gate->measured <= j.gate->limit));
        }
  return lines;
}

Gates read_gates(const std::string& lines) {
  Gates gates;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    std::istringstream row(line);
    std::string place, value, measured, limit, holds;
    if (!std::getline(row, place, '\t') || !std::getline(row, value, '\t') || !std::getline(row, measured, '\t') ||
        !std::getline(row, limit, '\t') || !(row >> holds))
      continue;
    gates[place] = {std::strtod(value.c_str(), nullptr), std::strtod(measured.c_str(), nullptr),
                    std::strtod(limit.c_str(), nullptr), holds == "1"};
  }
  return gates;
}

}  // namespace handhold::mutants
