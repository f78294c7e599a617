// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

namespace handhold::compare::testing {

/// What is known of a case: how much of it there is, how tight it is, how much of it guards little.
struct RatchetRow {
  int runs{}, claims{}, asked{}, studies{};
  std::string limits{};  ///< a digest of all limits, to six digits
  int vacuous{};         ///< gates that may be vacuous

  [[nodiscard]] friend bool operator==(const RatchetRow&, const RatchetRow&) = default;
};

/// The rows of tests/compare/ratchet.txt by case.
[[nodiscard]] std::map<std::string, RatchetRow> read_ratchet();
void write_ratchet(const std::map<std::string, RatchetRow>& rows);

/// HANDHOLD_RATCHET=write: the tests write what they find instead of comparing it.
[[nodiscard]] bool ratchet_is_written();

}  // namespace handhold::compare::testing
