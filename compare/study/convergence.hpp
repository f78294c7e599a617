// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace handhold::compare {

/// Slope of log(error) over log(dt): the order of accuracy that the runs show.
struct Order {
  double slope{};
  double standard_error{};
};

/// Fits a line through (log dt, log error) by least squares. All numbers positive, at least three runs, else both are
/// NaN.
[[nodiscard]] Order observed_order(const std::vector<double>& dt, const std::vector<double>& error);

}  // namespace handhold::compare
