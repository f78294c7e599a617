// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/gate.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/model/defect.hpp"

namespace handhold::compare {

bool passes(const Gate& gate) noexcept {
  return gate.bound == Bound::at_most ? DEFECT(nan_passes, gate.measured <= gate.limit, !(gate.measured > gate.limit))
                                      : gate.measured >= gate.limit;
}

bool is_vacuous(const Gate& gate) noexcept {
  constexpr double slack = 100;
  if (!passes(gate) || gate.limit == 0) return false;
  if (gate.bound == Bound::at_least) return gate.measured > slack * gate.limit;
  return gate.limit > DEFECT(vacuous_unseen, slack, 1e12) * std::max(gate.measured, gate.rounding);
}

std::string sentence(const Gate& gate) {
  const bool at_most = gate.bound == Bound::at_most;
  const auto* sign = passes(gate) ? (at_most ? "<=" : ">=") : (at_most ? ">" : "<");
  const std::string unit = gate.unit.empty() ? "" : " " + gate.unit;
  if (std::isnan(gate.measured)) return fmt::format("{}: not found in the recording", gate.quantity);
  return fmt::format("{} {:.2g}{} {} {:.2g}{}", gate.quantity, gate.measured, unit, sign, gate.limit, unit);
}

}  // namespace handhold::compare
