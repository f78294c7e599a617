// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/convergence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gsl/gsl_fit.h>

namespace handhold::compare {
namespace {

std::vector<double> logs(const std::vector<double>& values) {
  std::vector<double> out(values.size());
  std::ranges::transform(values, out.begin(), [](double v) { return std::log(v); });
  return out;
}

bool all_positive(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double v) { return v > 0 && std::isfinite(v); });
}

}  // namespace

Order observed_order(const std::vector<double>& dt, const std::vector<double>& error) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (dt.size() != error.size() || dt.size() < 3 || !all_positive(dt) || !all_positive(error)) return {nan, nan};
  const auto x = logs(dt);
  const auto y = logs(error);
  double intercept{}, slope{}, cov00{}, cov01{}, variance{}, residuals{};
  gsl_fit_linear(x.data(), 1, y.data(), 1, x.size(), &intercept, &slope, &cov00, &cov01, &variance, &residuals);
  return {.slope = slope, .standard_error = std::sqrt(variance)};
}

}  // namespace handhold::compare
