// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cases/hand/trace.hpp"
#include "cases/model/hand_motion.hpp"

namespace handhold {

/// What a hand in a trace does.
struct HandSummary {
  Side side{};
  double tracked{};                              ///< share of the time stamps, 0 to 1
  double least_confidence{}, most_confidence{};  ///< over tracked samples
  std::vector<Interval> lost{};                  ///< from the last tracked stamp before to the first after
  std::array<double, 15> bones{};      ///< segment of each capsule: joint to joint, fingertips to the ball [m]
  double palm_speed{};                 ///< largest step over its time [m/s]
  double palm_step{};                  ///< largest, between successive tracked samples [m]
  double palm_noise{};                 ///< high-pass residual in the slowest quarter, rms per axis [m]
  double pinch_least{}, pinch_most{};  ///< distance of the axes' ends of thumb and index [m]
  double pinch_least_at{};             ///< [s]
  std::vector<Interval> pinched{};     ///< skins of the two tips apart by less than 5 mm, 0.1 s or longer
  std::vector<Interval> fist{};        ///< all four fingers bent by more than 150 degrees, 0.1 s or longer
};

/// What `handhold trace info` shows.
struct TraceSummary {
  std::string name{};
  std::string source_frame{};
  std::size_t frames{};
  double duration{};             ///< [s]
  double tick{};                 ///< median time between stamps [s]
  double jitter{};               ///< rms deviation from the tick, gaps left out [s]
  std::vector<Interval> gaps{};  ///< stamps more than 1.5 ticks apart
  std::vector<HandSummary> hands{};
  std::vector<std::string> warnings{};
};

/// Throws InputError for a trace that is not valid; one with fewer than two stamps has zero duration and tick.
[[nodiscard]] TraceSummary summarize(const Trace& trace);

/// A few lines of text, with units.
[[nodiscard]] std::string to_text(const TraceSummary& summary);

}  // namespace handhold
