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

  /// Place of the joint of that name in the format's order, or nothing.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view joint_name) const;
  /// All names, separated by commas.
  [[nodiscard]] std::string names() const;
};

/// "leap" (22: palm, wrist and LeapJS's mcp, pip, dip, tip of each finger), "openxr" (26, XrHandJointEXT), "webxr" (25,
/// XRHandJoint) or "mano" (21: wrist, then thumb to little, four each). Throws InputError for another name.
[[nodiscard]] const JointSet& joint_set(std::string_view name);

}  // namespace handhold
