// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reference/rigid/modes.hpp"

namespace handhold::reference::rigid {

/// A quantity that must stay >= 0 while the modes last, and may cross zero transversally only.
struct Witness {
  enum class Kind {
    cone,    ///< stick: μ_s N − |f|
    normal,  ///< closed: N
    ahead,   ///< slip: u · held
    gap,     ///< open
    loose,   ///< open, force-controlled: −N(t)
  };

  Kind kind{};
  double value{};
  bool falling{true};  ///< of a gap: whether it closes
};

/// Two a closed support, one an open one, in the order of the supports.
[[nodiscard]] std::vector<Witness> witnesses(const RigidProblem& problem, double t, const Modes& modes,
                                             const std::vector<Reaction>& reactions);

/// Whether a witness tells of an event at `now`, given its value `before` at the beginning of the step. A gap just left
/// and a slip just begun start at zero with noise of either sign: they tell of something only if they had been
/// positive, or fall below the noise.
[[nodiscard]] bool tells(const Witness& before, const Witness& now, double noise);

}  // namespace handhold::reference::rigid
