// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace handhold::reports {

/// A number in [low, high]; unlike CLI::Range it refuses NaN.
[[nodiscard]] inline CLI::Validator number_in(double low, double high) {
  const auto check = [low, high](const std::string& text) -> std::string {
    double value{};
    const bool good = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
    return good ? ""
                : "'" + text + "' is no number from " + CLI::detail::to_string(low) + " to " +
                      CLI::detail::to_string(high);
  };
  return CLI::Validator(check, "", "number_in");
}

}  // namespace handhold::reports
