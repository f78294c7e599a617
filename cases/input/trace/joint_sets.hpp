// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace handhold {

/// Our name for a joint: 4 finger + n, finger: thumb 0 ... little 4; n counts from the knuckle (thumb: from its
/// carpometacarpal joint) to the tip 3. Then wrist and palm.
inline constexpr int wrist_joint = 20;
inline constexpr int palm_joint = 21;
inline constexpr int joint_count = 22;
inline constexpr int unused_joint = -1;  ///< in the file, but without use to us (the fingers' metacarpal bases)

[[nodiscard]] constexpr int joint_of(int finger, int n) { return 4 * finger + n; }

/// Where a format puts the joint that it calls a fingertip.
enum class TipPlace {
  bone,  ///< at the end of the bone: the skin reaches further by the soft tip
  ball,  ///< centre of a ball that touches the skin: the joint's radius away from it
  skin   ///< on the skin
};

/// The joints of a hand as a format orders and names them.
struct JointSet {
  struct Entry {
    std::string_view name;
    int joint;  ///< ours, or unused_joint
  };
  std::string_view name;
  std::vector<Entry> entries;
  TipPlace tip;
  bool minus_z_forward;  ///< joint frames: -z towards the fingertip and y dorsal (OpenXR), not z
  std::string_view up;   ///< the axis that points up where the file does not say

  /// Place of the joint of that name in the format's order, or nothing. Spelling does not count (plain_joint_name).
  [[nodiscard]] std::optional<std::size_t> find(std::string_view joint_name) const;
  /// All names, separated by commas.
  [[nodiscard]] std::string names() const;
};

/// The words of a joint's name that tell joints apart, in lower case with underscores: "index_proximal" of
/// "index-finger-phalanx-proximal", "IndexProximal" and "XR_HAND_JOINT_INDEX_PROXIMAL_EXT"; "little_tip" of
/// "PINKY_TIP".
[[nodiscard]] std::string plain_joint_name(std::string_view name);

/// Words of a name of any spelling, in lower case: "left", "index", "tip", "x" of "LeftIndexTip_x".
[[nodiscard]] std::vector<std::string> words_of(std::string_view name);

/// All sets, the ones that are told by fewer joints last.
[[nodiscard]] const std::vector<JointSet>& joint_sets();

/// "leap" (22: palm, wrist and LeapJS's mcp, pip, dip, tip of each finger), "openxr" (26, XrHandJointEXT), "webxr" (25,
/// XRHandJoint), "mano" (21: wrist, then thumb to little, four each), "mediapipe" (the same order; its y points down)
/// or "mano-model" (21 in the order of MANO's own model: wrist, index, middle, little, ring, thumb, then the tips).
/// Capitals do not count. Throws InputError for another name.
[[nodiscard]] const JointSet& joint_set(std::string_view name);

}  // namespace handhold
