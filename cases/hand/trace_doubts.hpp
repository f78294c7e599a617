// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cases/hand/trace.hpp"

namespace handhold {

/// Evidence that well-formed data is not what a hand does, and the likely cure.
struct Doubt {
  std::string evidence{};  ///< a clause with hand and numbers
  std::string cure{};      ///< an imperative clause
  bool meaningless{};      ///< a simulation of it says nothing: a unit wrong by ten or more
};

/// Bones of a length that none of a hand of this size has, against the others: phalanges of the model.
[[nodiscard]] std::vector<int> odd_bones(const HandModel& model);

/// "evidence (cure)".
[[nodiscard]] std::string to_text(const Doubt& doubt);

/// What looks wrong in a valid trace: size of the hand, lengths of single bones, distance of the wrist, radii, bones
/// that do not point along their finger, fingers that bend backwards (side or handedness mistaken), the rate of the
/// frames, and steps of a hand that then stays elsewhere. Compared with `mean_anatomy`, whose spread over adults and
/// children is a factor of 0.55 to 1.3; limits lie beyond it by as much again. One-frame glitches: trace_glitches.hpp.
[[nodiscard]] std::vector<Doubt> doubts(const Trace& trace);

}  // namespace handhold
