// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstddef>
#include <string>
#include <vector>

#include "cases/hand/trace.hpp"

namespace handhold {

/// A hand or some of its phalanges that is elsewhere for one to three frames and then back.
struct Glitch {
  std::size_t hand{};
  std::size_t first{}, count{};  ///< samples of the trace
  std::bitset<phalanx_count> phalanges{};
  double distance{};  ///< largest, from the straight line between the samples before and after [m]
};

/// Excursions r of a phalanx's centroid from the straight line between its neighbours in time that
///   - need an acceleration 8 r / T² of more than 50 m/s² (out and back within T), and
///   - exceed eight times (median of the twenty excursions around it + chord / 4 + 1 mm).
///
/// False alarms: for Gaussian noise of any size r is a Maxwell variable, and eight medians are twelve standard
/// deviations of it: below 1e-30 a sample. Recordings of hands come no further than three times, not eight.
/// Stretches with lost samples or gaps between them are not judged.
[[nodiscard]] std::vector<Glitch> find_glitches(const Trace& trace);

/// Interpolates what jumps (whole fingers, or the hand if its palm does) between the samples before and after: straight
/// in position, along the great circle in orientation. Off by at most a h² / 2 at a true acceleration a and tick h.
void bridge(Trace& trace, const std::vector<Glitch>& glitches);

/// "right hand, frame 12 (0.706 s): index_proximal, index_intermediate lie 155 mm aside for 1 frame".
[[nodiscard]] std::string to_text(const Trace& trace, const Glitch& glitch);

}  // namespace handhold
