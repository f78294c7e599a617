// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/judge/gate.hpp"
#include "tests/bench/series.hpp"

namespace handhold::bench {

/// What the real-time path is to reach (docs/benchmarks.md): ratios of least medians, and steadiness. Only goals whose
/// series are there.
[[nodiscard]] std::vector<compare::Gate> goals(const std::vector<Series>& all);

}  // namespace handhold::bench
