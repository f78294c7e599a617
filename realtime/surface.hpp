#pragma once

#include <Eigen/Core>

#include "cases/geometry/voxel_field.hpp"

namespace handhold::realtime {

/// An anchor: a point of the object's surface with its outward normal, in O.
struct Anchor {
  Eigen::Vector3d C_O{Eigen::Vector3d::Zero()};
  Eigen::Vector3d n_O{Eigen::Vector3d::Zero()};
};

/// The surface point nearest to `p_O`: along the field's gradient from outside, exactly (triangles) from inside, where
/// the nearest sheet is not the one that the gradient of a thin wall points to. False (and `anchor` untouched) when p
/// is beyond the band.
[[nodiscard]] bool foot(const VoxelField& field, const Eigen::Vector3d& p_O, Anchor& anchor);

/// Slides an anchor by the tangential `step_O` along the surface, voxel by voxel. It stops where the next voxel would
/// leave the band, fall onto another sheet or turn the normal by more than 60 degrees: an occluding part blocks it
/// (Höll et al. 2018, Fig. 3). A step that is not finite moves nothing.
void slide(const VoxelField& field, const Eigen::Vector3d& step_O, Anchor& anchor);

}  // namespace handhold::realtime
