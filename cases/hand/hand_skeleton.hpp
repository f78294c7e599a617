// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <Eigen/Core>

#include "cases/model/hand_model.hpp"
#include "cases/model/pose.hpp"

namespace handhold {

/// Where the fingers sit on the palm: for each the frame of its first bone when stretched out, origin in the knuckle
/// (thumb: carpometacarpal joint), x the hinge, in the palm's frame. Our own layout: knuckles spread evenly over the
/// palm's breadth, on average at its end; the thumb is half opposed.
using FingerBases = std::array<Pose, 5>;

[[nodiscard]] FingerBases finger_bases(const HandModel& model, Side side);

/// Axis about which a finger bends (positive: towards the palm), unit, in the palm's frame.
[[nodiscard]] Eigen::Vector3d hinge_axis(int finger, Side side);

/// Joint angles of a finger [rad].
struct FingerPose {
  std::array<double, 3> flexion{};  ///< knuckle first, positive bends towards the palm
  double spread{};                  ///< positive turns towards the thumb's side
};

/// The finger at `curl` between 0 (straight) and 1 (fist): 75, 100 and 65 degrees, thumb 25, 45 and 60.
[[nodiscard]] FingerPose curled(int finger, double curl);

/// Poses of all phalanges (forward kinematics) from the palm's pose.
[[nodiscard]] std::array<Pose, phalanx_count> forward_kinematics(const HandModel& model, Side side, const Pose& X_WPalm,
                                                                 const std::array<FingerPose, 5>& fingers);

}  // namespace handhold
