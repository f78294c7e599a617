// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "cases/hand/trace.hpp"
#include "cases/model/hand_motion.hpp"

namespace handhold {

/// What a tracker does to a motion. The defaults do nothing.
struct SensorFaults {
  double position_noise{0};      ///< standard deviation, white, per axis and phalanx [m]; Leap: 2e-5 to 1e-4
  double rotation_noise{0};      ///< of a rotation vector, per axis [rad]
  std::vector<Interval> gaps{};  ///< the hands are lost in there, both ends included [s]
  double gap_rate{0};            ///< further gaps at random: mean number a second (Poisson), per hand [1/s]
  double gap_length{0.03};       ///< of those [s]
  double dropout{0};             ///< probability that a frame is missing altogether, 0 to 1
  double duplicate{0};  ///< probability that a frame repeats the stamp before it: the readers drop it, so do we
  std::vector<double>
      id_changes{};  ///< the tracker takes each hand for a new one: it is lost for `id_change_frames` [s]
  int id_change_frames{3};
  double position_step{0};    ///< positions are rounded to multiples of it [m]; WebXR recorders: 1e-3
  double quaternion_step{0};  ///< components are rounded to multiples of it; WebXR recorders: 1e-3
};

/// Throws InputError for values out of range.
void validate(const SensorFaults& faults);

/// `trace` as a tracker with these faults would have recorded it. The first and the last frame always stay. The same
/// seed gives the same bits with every standard library (mt19937_64, our own normal deviates).
[[nodiscard]] Trace with_faults(const Trace& trace, const SensorFaults& faults, std::uint64_t seed);

}  // namespace handhold
