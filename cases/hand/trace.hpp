// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "cases/model/hand_model.hpp"
#include "cases/model/pose.hpp"

namespace handhold {

/// One hand at one time stamp.
struct HandSample {
  std::array<Pose, phalanx_count> X_WP{};  ///< of every phalanx, frames as in hand_model.hpp; meaningless when lost
  double confidence{};                     ///< the tracker's own, 0 to 1
  bool tracked{false};
};

struct TraceHand {
  Side side{Side::right};
  HandModel model{};
  std::vector<HandSample> samples{};  ///< one per time stamp of the trace
};

/// A recording of tracked hands: what both engines are driven by.
///
/// Always SI, right-handed, world z up: readers convert and keep what the file said in `source_frame`.
struct Trace {
  std::string name{};
  std::string source_frame{};  ///< e.g. "mm, y up, right-handed"
  std::vector<double> t{};     ///< strictly increasing [s]
  std::vector<TraceHand> hands{};
  std::vector<std::string> warnings{};  ///< what a reader dropped or repaired, one sentence each
};

/// Throws InputError unless time is finite, below 1e11 s and strictly increasing, every hand has one sample a stamp,
/// and every tracked sample a confidence of 0 to 1 and poses that are finite, within 1000 km of the origin, with unit
/// quaternions (within 1e-6).
void validate(const Trace& trace);

}  // namespace handhold
