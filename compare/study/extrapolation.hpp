// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "cases/catalogue/claim.hpp"
#include "compare/engine/engine.hpp"

namespace handhold::compare {

/// A quantity of L2 at growing stiffness, continued to L1.
struct Extrapolation {
  std::vector<double> stiffness{};  ///< ascending, each the same multiple of the one before
  std::vector<double> value{};      ///< of the quantity
  double limit{};                   ///< at infinite stiffness
  double error{};                   ///< estimate: by how much the last step of stiffness still moved the limit
  double exponent{};                ///< p of the observed error ~ K^-p; NaN if the values do not fall into line
  bool regular{};                   ///< exponent between 1/2 and 2: the 1/K of springs is what is seen
};

/// Richardson's extrapolation in 1/K. With ratio r and the last values v1, v2, v3: limit = v3 + (v3 − v2)/(r − 1),
/// which cancels the leading 1/K; error = its difference to v2 + (v2 − v1)/(r − 1); p = log((v2 − v1)/(v3 − v2)) / log
/// r. Values that are not regular are not continued: limit = v3, error = twice the largest of their two differences.
///
/// Throws InputError for fewer than three values, or stiffnesses that do not grow by one ratio > 1.
[[nodiscard]] Extrapolation extrapolate(const std::vector<double>& stiffness, const std::vector<double>& value);

/// Runs `scene(K)` at every stiffness, reads `what` off it, and extrapolates. Returning false from `progress` stops:
/// then, and where a recording does not show the quantity, values are NaN.
[[nodiscard]] Extrapolation extrapolate_to_rigid(const Engine& engine,
                                                 const std::function<Scene(double stiffness)>& scene,
                                                 const catalogue::Measure& what, const std::vector<double>& stiffness,
                                                 const EngineOptions& options = {}, const Progress& progress = {});

}  // namespace handhold::compare
