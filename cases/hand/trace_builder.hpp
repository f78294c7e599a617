// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "cases/hand/trace.hpp"

namespace handhold {

/// Poses of all phalanges of one hand as a function of time [s].
using PoseFunction = std::function<std::array<Pose, phalanx_count>(double t)>;

/// Samples `poses` at `rate` [Hz] from `begin` to `end` [s], both included. Sample well beyond the scene's duration on
/// both sides: the splines of TraceSpline are natural at the ends, and their end effect decays by 3.7 a sample.
[[nodiscard]] Trace sample_trace(const std::string& name, Side side, const HandModel& model, const PoseFunction& poses,
                                 double begin, double end, double rate);

}  // namespace handhold
