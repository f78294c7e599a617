// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/hand/trace.hpp"
#include "cases/model/pose.hpp"

namespace handhold {

/// The trace as seen after the whole of it is moved by `X_WT` (every tracked pose becomes X_WT X_TP), with the time
/// `start` [s] of the trace as new zero. Names, confidence and warnings stay.
[[nodiscard]] Trace moved(Trace trace, const Pose& X_WT, double start);

/// The trace with all lengths, of poses and shapes, times `length`, and all times times `time`.
[[nodiscard]] Trace scaled(Trace trace, double length, double time);

}  // namespace handhold
