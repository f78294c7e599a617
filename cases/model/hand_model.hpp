// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>

#include <Eigen/Core>

namespace handhold {

enum class Side { left, right };

/// "left" or "right", as all files say it.
[[nodiscard]] std::string_view to_string(Side side);

inline constexpr int phalanx_count = 16;
inline constexpr int palm =
    15;  ///< phalanges 0 to 14 are 3 * finger + bone, finger: thumb 0 ... little 4, bone: proximal first

/// "thumb_metacarpal", "thumb_proximal", "thumb_distal", "index_proximal", "index_intermediate", "index_distal", ...
/// "palm".
[[nodiscard]] std::string_view phalanx_name(int phalanx);

/// The phalanx of that name; throws InputError listing the names if there is none.
[[nodiscard]] int phalanx_from_name(std::string_view name);

/// A segment along the phalanx's z axis, thickened by `radius`. Frame P: origin at the centroid, z towards the
/// fingertip, y dorsal (away from the palm side), x = y × z.
struct Capsule {
  double half_length{};  ///< of the segment, so the whole is 2 (half_length + radius) long [m]
  double radius{};       ///< [m]
};

/// Frame P: origin at the centroid, z towards the fingers, y dorsal, x = y × z.
struct PalmBox {
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};  ///< [m]
};

using PhalanxShape = std::variant<Capsule, PalmBox>;

/// The paper's hand: three capsules a finger and one cuboid for the palm (Höll et al. 2018, section 3.2).
struct HandModel {
  std::array<Capsule, 15> capsules{};
  PalmBox palm_box{};

  [[nodiscard]] PhalanxShape shape(int phalanx) const;
};

/// Throws InputError, its sentence beginning with `who` ("hand 0"), for a radius or a half extent that is not above 0
/// and at most 1 m, or a half length that is not 0 to 1 m.
void validate(const HandModel& model, const std::string& who);

/// Capsule of a bone between two joints: the segment joins the joints, so neighbours overlap in a ball around the
/// joint.
[[nodiscard]] Capsule capsule_of_bone(double length, double radius);

/// Capsule of the last bone, `skin_length` from its joint to the end of the skin [m]: the segment starts at the joint
/// and ends one radius before the end of the skin (a ball at the joint if the fingertip is shorter than its radius).
[[nodiscard]] Capsule capsule_of_fingertip(double skin_length, double radius);

/// Mean adult hand: bones and soft tips of 66 adults (Buryanov & Kotiuk 2010), radii of Leap's default hand; the palm
/// is our choice (knuckle breadth 80 mm, thickness 28 mm, carpus 25 mm and middle metacarpal 64.6 mm).
struct Anatomy {
  std::array<double, 15> bones{};                              ///< 3 * finger + bone, joint to joint [m]
  std::array<double, 5> soft_tip{};                            ///< skin beyond the last bone [m]
  std::array<double, 5> radius{};                              ///< [m]
  Eigen::Vector3d palm_half_extents{Eigen::Vector3d::Zero()};  ///< [m]
};

[[nodiscard]] Anatomy mean_anatomy();

/// The hand of `mean_anatomy`, all lengths times `scale`.
[[nodiscard]] HandModel anatomical_hand(double scale = 1);

}  // namespace handhold
