// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "cases/model/hand_motion.hpp"

namespace handhold {

/// The gap between the last capsules of the thumb and of another finger, at one time.
struct Grip {
  double t{};                                         ///< [s]
  double gap{};                                       ///< between their skins, < 0 where they overlap [m]
  Eigen::Vector3d middle_W{Eigen::Vector3d::Zero()};  ///< of the gap
  Eigen::Vector3d axis_W{Eigen::Vector3d::UnitZ()};   ///< unit, from the thumb to the finger
};

/// Last phalanx of finger 0 (thumb) to 4 (little).
[[nodiscard]] constexpr int last_phalanx(int finger) { return 3 * finger + 2; }

/// The grip of thumb and `finger` (1 to 4) at `t`.
[[nodiscard]] Grip grip_at(const HandMotion& motion, int finger, double t);

/// The grips of an interval of presence, every `tick` [s].
[[nodiscard]] std::vector<Grip> sample_grips(const HandMotion& motion, int finger, const Interval& present,
                                             double tick);

/// A stretch in which the hand stays closed.
struct Closing {
  int finger{};
  double begin{};     ///< the gap has just closed to the threshold [s]
  double end{};       ///< it opens again, or the trace ends [s]
  double mean_gap{};  ///< over the stretch [m]
};

/// Stretches of `grips` with a gap of at most `closed`, after one of at least `open` [m] since the last stretch: in
/// time.
[[nodiscard]] std::vector<Closing> find_closings(const std::vector<Grip>& grips, int finger, double closed,
                                                 double open);

}  // namespace handhold
