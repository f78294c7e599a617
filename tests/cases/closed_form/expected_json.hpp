// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/shared_data.hpp"

namespace handhold::testing {

/// One parameter set of the project's list of expected values, which another program computed.
struct ExpectedSet {
  nlohmann::json params{}, expected{};

  [[nodiscard]] double given(const char* name) const { return params.at(name).get<double>(); }
  [[nodiscard]] double number(const char* name) const { return expected.at(name).get<double>(); }
};

/// The parameter sets of case `id` in expected.json; empty where the shared data are absent.
inline std::vector<ExpectedSet> expected_sets(const std::string& id) {
  std::vector<ExpectedSet> sets;
  std::ifstream file(test::shared_data("expected.json"));
  if (!file) return sets;
  for (const auto& entry : nlohmann::json::parse(file))
    if (entry.at("id") == id) sets.push_back({entry.at("params"), entry.at("expected")});
  return sets;
}

}  // namespace handhold::testing
