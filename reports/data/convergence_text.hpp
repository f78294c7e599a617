// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/catalogue/scenes/limit_scenes.hpp"
#include "compare/study/extrapolation.hpp"
#include "compare/study/self_convergence.hpp"

namespace handhold::reports {

/// A study of one scene, ready to be printed.
struct NamedConvergence {
  std::string name{}, what{};
  compare::SelfConvergence study{};
  /// Of every run: the largest |measured − closed form| over its limit, NaN where the recording does not show one;
  /// empty if the scene has no closed form.
  std::vector<double> closed_form{};
  std::vector<std::string> closed_form_lines{};  ///< the errors of the tightest run, one a quantity
  /// Of every run, its distance to a recording by another solver; empty if there is none.
  std::vector<compare::Gap> independent{};
};

/// The heading of the columns of convergence_rows.
[[nodiscard]] std::string convergence_heading();

/// A line a setting, then what was observed: orders, closed forms, the independent recording.
[[nodiscard]] std::string convergence_rows(const NamedConvergence& named);

/// A line a stiffness, then the limit against the closed form of L1.
[[nodiscard]] std::string stiffness_rows(const catalogue::LimitScene& scene, const compare::Extrapolation& result);

/// Whether the limit lies within its error estimate, or a part in 10^6, of the truth.
[[nodiscard]] bool reaches_truth(const catalogue::LimitScene& scene, const compare::Extrapolation& result);

}  // namespace handhold::reports
