// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/catalogue/claim.hpp"

namespace handhold::compare {

enum class Bound { at_most, at_least };

/// One pass/fail question, with all that is needed to judge the question itself.
struct Gate {
  std::string quantity{};  ///< e.g. "slip onset error"
  double measured{};
  Bound bound{Bound::at_most};
  double limit{};
  std::string unit{};  ///< of both numbers; empty when dimensionless
  catalogue::Pedigree pedigree{catalogue::Pedigree::exact};
  std::string reason{};  ///< of the limit
  double rounding{};     ///< error of the numbers themselves, below which nothing is measured; same unit
};

/// False when `measured` or `limit` is NaN.
[[nodiscard]] bool passes(const Gate& gate) noexcept;

/// True when a gate could be 100 times tighter than what was measured, or than rounding, and still hold: it guards
/// little. Never for a limit of zero.
[[nodiscard]] bool is_vacuous(const Gate& gate) noexcept;

/// "slip distance error 8.3e-03 m > 5.0e-03 m"
[[nodiscard]] std::string sentence(const Gate& gate);

}  // namespace handhold::compare
