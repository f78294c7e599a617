// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/study/placing_trial.hpp"

namespace handhold::reports {

/// Where the object was put and how it fared there, what came second, and, when nothing held, why: lines for the
/// terminal.
[[nodiscard]] std::string placing_text(const compare::Placing& placing, const Body& body);

/// "weight 1.24 N, this grip carries 0.31 N at mu 0.46; it would hold at stiffness 400 N/m or at 35 g": why the winner
/// does not hold, one sentence; empty if it does.
[[nodiscard]] std::string why_lost(const compare::Placing& placing, const Body& body);

}  // namespace handhold::reports
