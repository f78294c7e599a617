// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/judge/suite.hpp"

namespace handhold::reports {

struct TableStyle {
  bool colour{false};  ///< ANSI colours beside the words, never in their place
};

/// The result for a terminal, 140 columns wide: a line a quantity, then failed gates in words with the reasons of their
/// limits, vacuous gates, frame times, and the verdict as the last line.
[[nodiscard]] std::string text_table(const compare::SuiteResult& result, const TableStyle& style = {});

}  // namespace handhold::reports
