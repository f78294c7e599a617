// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

namespace handhold::compare {

/// Percentiles of the CPU time a frame [s]; all zero for an empty list.
struct FrameTimes {
  std::size_t frames{};
  double p50{}, p90{}, p99{}, p999{}, max{};
};

[[nodiscard]] FrameTimes frame_times(std::vector<double> seconds);

}  // namespace handhold::compare
