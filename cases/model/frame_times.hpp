// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cases/model/scene.hpp"

namespace handhold {

/// Ends of the frames of a recording, `rate` [Hz] of them a second, the last at `duration` [s]: no sliver of a frame
/// there.
[[nodiscard]] std::vector<double> regular_frames(double duration, double rate);

/// When the scene's traces saw a hand, within (0, duration), and `duration`. Of two stamps less than 1 µs apart the
/// second is left out.
[[nodiscard]] std::vector<double> trace_frames(const Scene& scene);

/// Throws InputError unless the times ascend, begin after 0 and end at `duration`.
void validate_frames(const std::vector<double>& times, double duration);

}  // namespace handhold
