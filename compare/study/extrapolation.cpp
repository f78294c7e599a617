// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/extrapolation.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "compare/measure/measure.hpp"

namespace handhold::compare {
namespace {

constexpr double least_exponent = 0.5, most_exponent = 2;

double common_ratio(const std::vector<double>& stiffness) {
  if (stiffness.size() < 3)
    throw InputError(
        fmt::format("{} stiffnesses: three at least tell an exponent (give K, 4 K, 16 K)", stiffness.size()));
  const double ratio = stiffness[1] / stiffness[0];
  for (std::size_t i = 0; i + 1 < stiffness.size(); ++i) {
    const bool grows = stiffness[i] > 0 && ratio > 1 && std::isfinite(stiffness[i + 1]);
    if (!grows || !(std::abs(stiffness[i + 1] / stiffness[i] / ratio - 1) < 1e-9))
      throw InputError(fmt::format("stiffness {:g} after {:g} N/m: must grow by one ratio > 1 (give K, 4 K, 16 K)",
                                   stiffness[i + 1], stiffness[i]));
  }
  return ratio;
}

}  // namespace

Extrapolation extrapolate(const std::vector<double>& stiffness, const std::vector<double>& value) {
  const double ratio = common_ratio(stiffness);
  if (value.size() != stiffness.size())
    throw InputError(
        fmt::format("{} values at {} stiffnesses: one each (drop the others)", value.size(), stiffness.size()));
  Extrapolation out{.stiffness = stiffness, .value = value};
  const double v1 = *(value.end() - 3), v2 = *(value.end() - 2), v3 = value.back();
  out.exponent = std::log((v2 - v1) / (v3 - v2)) / std::log(ratio);
  out.regular = out.exponent >= least_exponent && out.exponent <= most_exponent;
  out.limit = v3;
  out.error = 2 * std::max(std::abs(v3 - v2), std::abs(v2 - v1));
  if (!out.regular) return out;
  out.limit = v3 + (v3 - v2) / (ratio - 1);
  out.error = std::abs(out.limit - (v2 + (v2 - v1) / (ratio - 1)));
  return out;
}

Extrapolation extrapolate_to_rigid(const Engine& engine, const std::function<Scene(double stiffness)>& scene,
                                   const catalogue::Measure& what, const std::vector<double>& stiffness,
                                   const EngineOptions& options, const Progress& progress) {
  (void)common_ratio(stiffness);  // before the work, not after it
  std::vector<double> values;
  for (const double k : stiffness) {
    const Scene stiff = scene(k);
    values.push_back(measure(stiff, engine.play(stiff, options, progress), what));
  }
  return extrapolate(stiffness, values);
}

}  // namespace handhold::compare
