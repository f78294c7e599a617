// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace handhold::mutants {

struct GateLine {
  double value{}, measured{}, limit{};
  bool holds{};
};

/// By place and quantity: "H07/slides: slip error, realtime".
using Gates = std::map<std::string, GateLine>;

/// Plays the cases with every engine that has gates, in this process, and writes a line a gate: place, measured value,
/// error, limit, 1 or 0, separated by tabs.
[[nodiscard]] std::string played(const std::vector<std::string>& cases);

/// The gates of such lines; what is no such line is passed over.
[[nodiscard]] Gates read_gates(const std::string& lines);

}  // namespace handhold::mutants
