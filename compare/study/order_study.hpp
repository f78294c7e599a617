// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/judge/gate.hpp"
#include "compare/study/convergence.hpp"

namespace handhold::compare {

/// Error of one quantity against the step of an engine. The frame is shortened with the step: a hand is known at frames
/// only, so refining the step alone converges to the motion of a hand that moves between frames as the engine guesses.
struct OrderStudy {
  std::string engine{};
  std::vector<double> step{};   ///< [s], descending
  std::vector<double> error{};  ///< in the quantity's unit
  Order order{};
  Gate gate{};  ///< |order − 1| within its limit
};

/// Fits the order and makes the gate of a study whose steps and errors are known.
void conclude(OrderStudy& study, const catalogue::Claim& claim);

}  // namespace handhold::compare
