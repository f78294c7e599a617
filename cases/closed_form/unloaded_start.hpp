// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/closed_form/incline.hpp"

namespace handhold::closed_form {

/// A block laid at rest on a slope at t = 0, its springs in balance with its weight across the slope but not yet along
/// it: m x'' + C x' + K x = m g sin θ until it breaks away. L2: what compliance makes of C01's start. Between being
/// laid down and having its whole friction, the block gets a speed that a rigid one has not, which it keeps. Explains
/// a figure of docs/benchmarks.md; its cases start loaded, so that L1 and L2 agree.
struct UnloadedStart {
  Incline incline{};
  double mass{0.2};    ///< m [kg]
  double stiffness{};  ///< K, tangential, of all samples together [N/m], > 0
  double damping{};    ///< C, likewise [N s/m], >= 0
};

/// First time at which K x + C x' leaves the static cone, that is x'' falls to g (sin θ − μ_s cos θ) [s]; infinite if
/// it never does. A light damper lets the springs overshoot, so a slope that holds a rigid block need not hold this
/// one.
[[nodiscard]] double breakaway_time(const UnloadedStart& start);

/// Distance down the plane at time t >= 0 [m], while a block that broke away has not stopped: at once on slopes that do
/// not hold.
[[nodiscard]] double slip(const UnloadedStart& start, double t);

}  // namespace handhold::closed_form
