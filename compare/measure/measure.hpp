// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/catalogue/claim.hpp"
#include "cases/model/problem.hpp"
#include "cases/model/recording.hpp"

namespace handhold::compare {

/// Reads a quantity off a recording; NaN when the recording does not show it (no such event, instant beyond its end).
///
/// Between frames, positions are interpolated by the cubic through both frames' poses and velocities (exact for
/// constant acceleration); at an event, the state that the event carries is taken. What the body is measured against
/// comes from the problem: the phalanx of the first given patch, the first support of a rigid problem (W, if that
/// turns).
[[nodiscard]] double measure(const Problem& problem, const Recording& recording, const catalogue::Measure& what);

}  // namespace handhold::compare
