// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cases/model/hand_model.hpp"
#include "cases/model/pose.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold {

/// Which point of the phalanx a sample's spring pulls on: the paper's centroid (force starts only when the centroid is
/// inside, a dead zone of one radius) or the skin point that is deepest. See docs/contact-law.md.
enum class ReferencePoint { skin, centroid };

/// How a contact patch is spread around the point of first contact (Höll et al. 2018, section 3.2: several samples,
/// thumb and palm wider).
struct PatchOptions {
  int samples{8};                ///< on a ring, 1 to 32
  double finger_radius{0.003};   ///< of the ring [m]
  double thumb_radius{0.0045};   ///< [m]
  double palm_radius{0.02};      ///< [m]
  double contact_offset{0.002};  ///< a phalanx nearer than this gets a patch [m]
  ReferencePoint reference_point{ReferencePoint::skin};
};

/// Throws InputError for values out of range.
void validate(const PatchOptions& options);

/// The place of a phalanx that is nearest to (or deepest in) an object.
struct Nearest {
  double distance{};                                ///< of the skin to the surface, < 0 inside [m]
  Eigen::Vector3d skin_O{Eigen::Vector3d::Zero()};  ///< on the phalanx's skin
  Eigen::Vector3d axis_O{
      Eigen::Vector3d::Zero()};                  ///< the point of the capsule's segment (or palm's mid-plane) behind it
  Eigen::Vector3d n_O{Eigen::Vector3d::Zero()};  ///< unit, outward normal of the object there
};

/// `nearest` is exact for skins nearer than this; beyond, its distance is a lower bound [m].
inline constexpr double nearest_reach = 0.01;

/// Nearest place of `shape`, posed at X_OP in the object's frame: minimises the distance over the capsule's segment
/// (grid, then the root of its exact derivative, 1e-6 of its length) or over the palm's faces and rim (grid, then
/// pattern search on the interpolated field, so within a few µm). Among equals (a finger flat on a face) it takes the
/// one nearest to the middle. Does not allocate.
[[nodiscard]] Nearest nearest(const PhalanxShape& shape, const Pose& X_OP, const VoxelField& field);

/// At most this many samples a patch.
inline constexpr int max_samples = 32;

/// Sample points of a new patch, fixed in the phalanx's frame P until the patch is dropped: a ring in the plane tangent
/// to the object at the nearest point, through the skin point (or the phalanx's centroid), first sample along the
/// phalanx.
struct Patch {
  int count{};
  std::array<Eigen::Vector3d, max_samples> p_P{};  ///< [m]
};

[[nodiscard]] Patch seed_patch(int phalanx, const Pose& X_OP, const Nearest& nearest, const PatchOptions& options);

}  // namespace handhold
