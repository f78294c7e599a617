// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cases/catalogue/claim.hpp"
#include "cases/model/problem.hpp"

namespace handhold::catalogue {

/// Something to plot against time, with its truth.
struct Curve {
  std::string label{};  ///< e.g. "slip [m]"
  Measure measure{};    ///< displacement or rotation; `at` is ignored
  std::function<double(double t)> truth{};
};

/// One simulation of a case.
struct Run {
  std::string name{};     ///< e.g. "slides", "0.98 of the threshold"
  std::string variant{};  ///< "mirrored", "turned", ...: how it differs from the run of the same name; empty: plain
  std::function<Problem()> problem{};  ///< built on demand: voxelizing takes a moment
  std::vector<Claim> claims{};
  std::optional<Curve> curve{};
  std::string not_stepped{};  ///< why methods with a fixed step are not asked for this run; empty: they are
};

/// One analytic benchmark of the catalogue.
struct Case {
  std::string id{};  ///< e.g. "D02"; "L1-D02" and "L3-02" at other levels than L2
  std::string title{};
  Level level{Level::compliant};  ///< of its problems: which engines are asked
  std::string truth_level{};      ///< which model the truth is of, e.g. "L1 = L2"
  std::string statement{};        ///< the scene in words
  std::string formula{};          ///< the closed form, as text
  std::string note{};             ///< how the level of the truth and of the engines are reconciled (stiffness, ...)
  std::vector<Run> runs{};
};

/// All cases: L2 ascending in id, then L1, then L3.
[[nodiscard]] const std::vector<Case>& all_cases();

}  // namespace handhold::catalogue
