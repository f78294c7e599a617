#include "compare/gate.hpp"

#include <cmath>

#include <fmt/format.h>

namespace handhold::compare {

bool passes(const Gate& gate) noexcept {
  return gate.bound == Bound::at_most ? gate.measured <= gate.limit : gate.measured >= gate.limit;
}

bool is_vacuous(const Gate& gate) noexcept {
  if (!passes(gate) || gate.measured == 0 || gate.limit == 0) return false;
  const double slack = gate.bound == Bound::at_most ? gate.limit / gate.measured : gate.measured / gate.limit;
  return slack > 100;
}

std::string sentence(const Gate& gate) {
  const bool at_most = gate.bound == Bound::at_most;
  const auto* sign = passes(gate) ? (at_most ? "<=" : ">=") : (at_most ? ">" : "<");
  const std::string unit = gate.unit.empty() ? "" : " " + gate.unit;
  if (std::isnan(gate.measured)) return fmt::format("{}: not found in the recording", gate.quantity);
  return fmt::format("{} {:.2g}{} {} {:.2g}{}", gate.quantity, gate.measured, unit, sign, gate.limit, unit);
}

}  // namespace handhold::compare
