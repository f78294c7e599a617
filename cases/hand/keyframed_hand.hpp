// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "cases/hand/hand_skeleton.hpp"
#include "cases/hand/trace_builder.hpp"

namespace handhold {

/// A posture that the hand passes at rest.
struct HandKeyframe {
  double t{};   ///< [s]
  Pose X_WH{};  ///< wrist: origin at the middle of the palm's lower end, axes of the palm (z to the fingers, y dorsal)
  std::array<FingerPose, 5> fingers{};

  /// All fingers but the thumb at `curl`, the thumb at `thumb_curl`; 0 straight, 1 fist.
  [[nodiscard]] static HandKeyframe of_curl(double t, const Pose& X_WH, double curl, double thumb_curl);
};

/// A hand that goes from keyframe to keyframe by minimum jerk (Flash & Hogan 1985: 10 τ³ - 15 τ⁴ + 6 τ⁵), so that
/// position, rotation and joint angles are C2; it rests before the first and after the last. Throws InputError for no
/// keyframe, times that do not increase, and numbers that are not finite.
[[nodiscard]] PoseFunction keyframed_hand(const HandModel& model, Side side, std::vector<HandKeyframe> keyframes);

}  // namespace handhold
