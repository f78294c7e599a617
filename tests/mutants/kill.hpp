// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "tests/mutants/defects.hpp"
#include "tests/mutants/gates.hpp"

namespace handhold::mutants {

/// What became of one planted defect.
struct Fate {
  std::string killer{};  ///< "H07/slides: slip error, realtime", or a test; empty: it lives
  bool by_gate{false};
  int gates{};          ///< that fail
  double margin{};      ///< of gates: greatest error over its limit; wider limits than by that and it would live
  bool changed{false};  ///< any measured number differs from that without the defect, or a test failed
};

/// Plays the defect's cases, then its tests, in processes of `program` (this one) with the defect planted.
[[nodiscard]] Fate fate_of(const Defect& defect, const std::string& program);

/// Why the defect's cases and tests say nothing: one fails without any defect, or there is none. Empty: they do.
[[nodiscard]] std::string fault_of_sound(const Defect& defect, const std::string& program);

}  // namespace handhold::mutants
