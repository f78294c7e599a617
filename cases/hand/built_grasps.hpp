// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/hand/trace.hpp"

namespace handhold {

/// Grasps of a built hand, for where there is no recording: the whole hand or the fingers next to the thumb close on
/// nothing, hold still, lift by 10 cm or turn by 45 degrees about the forearm, and open; 3 s, at 90 Hz, the palm
/// sideways and the thumb up. Named "built power lift", "built power turn", "built tips lift", "built tips turn".
[[nodiscard]] std::vector<Trace> built_grasps();

}  // namespace handhold
