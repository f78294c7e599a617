// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "cases/hand/trace.hpp"
#include "cases/input/trace/joint_sets.hpp"

namespace handhold {

/// The joints of one hand in one frame, in W.
struct HandJoints {
  struct Joint {
    Eigen::Vector3d p_W{Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())};  ///< NaN: not given [m]
    std::optional<Eigen::Quaterniond> R_WJ{};  ///< z towards the fingertip, y dorsal
    double radius{};                           ///< distance to the skin [m]; 0: not given
  };
  std::array<Joint, joint_count> joints{};  ///< by our joint numbers (joint_sets.hpp)
  double confidence{1};

  [[nodiscard]] const Eigen::Vector3d& p(int joint) const { return joints[static_cast<std::size_t>(joint)].p_W; }
  /// All twenty joints of the fingers and either the wrist or a palm with its orientation are finite.
  [[nodiscard]] bool complete() const;
};

/// Pose of the palm's axes: from the palm joint's orientation, or z from the wrist to the middle of the index and
/// little knuckles and y dorsal in their plane. Its origin is the palm joint, or the wrist. Nothing if the joints lie
/// on a line.
[[nodiscard]] std::optional<Pose> palm_axes(Side side, const HandJoints& joints);

/// Which hand it is, from where the index knuckle lies; for files that do not say. Needs a palm joint with orientation.
[[nodiscard]] Side side_of(const HandJoints& joints);

/// Lengths of the bones from joint to joint, thumb to little, proximal first [m].
[[nodiscard]] std::array<double, 15> bone_lengths(const HandJoints& joints);

/// A hand from its joints, one entry a time stamp (nothing: lost).
///
/// Shapes: the bones' median lengths; radii as in the file, else those of the anatomical hand of the same size; the
/// palm reaches from the wrist to the knuckles. Bone frames: z from joint to joint, y from the joint's orientation,
/// else from the finger's hinge, an axis fixed in the palm; a bone of no length points as the one before it. Incomplete
/// frames and those with a degenerate palm count as lost; `warnings` says how many.
[[nodiscard]] TraceHand hand_from_joints(Side side, const std::vector<std::optional<HandJoints>>& frames, TipPlace tip,
                                         std::vector<std::string>& warnings);

}  // namespace handhold
