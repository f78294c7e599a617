// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cases/model/voxel_field.hpp"

namespace handhold::realtime {

/// An anchor: a point of the object's surface with its outward normal, in O.
struct Anchor {
  Eigen::Vector3d C_O{Eigen::Vector3d::Zero()};
  Eigen::Vector3d n_O{Eigen::Vector3d::Zero()};
};

/// The field's interpolated distance at a point, and its gradient by central differences over one voxel: continuous,
/// unlike that of the trilinear interpolant, whose jumps from cell to cell turn a normal by 10 degrees on a surface of
/// a few voxels' radius.
struct SmoothDistance {
  double distance{};
  Eigen::Vector3d gradient{Eigen::Vector3d::Zero()};
};
[[nodiscard]] SmoothDistance smooth_distance(const VoxelField& field, const Eigen::Vector3d& p_O);

/// The surface point nearest to `p_O`: along the field's gradient from outside, exactly (triangles) from inside,
/// however deep, where the nearest sheet is not the one that the gradient of a thin wall points to. False (and `anchor`
/// untouched) when p is outside beyond the band.
[[nodiscard]] bool foot(const VoxelField& field, const Eigen::Vector3d& p_O, Anchor& anchor);

/// How the normal of a touched place is taken.
enum class TouchNormal {
  smooth,  ///< of the interpolated distance: a mesh's facets are not felt
  face,    ///< of the triangle: edges stay sharp to the last bit
};

/// Where a point that moves straight from `from_O` to `to_O` touches: at the first crossing of the surface from outside
/// (exact triangles), so that no wall is too thin; at the nearest surface point if it was inside already. False if it
/// ends outside without having crossed.
[[nodiscard]] bool find_touch(const VoxelField& field, const Eigen::Vector3d& from_O, const Eigen::Vector3d& to_O,
                              TouchNormal normal, Anchor& anchor);

/// Slides the anchor of a sample that is at `sample_O` by the tangential `step_O` along the surface, voxel by voxel.
/// What a slider slips it has slipped, so that its spring never holds more than the cone lets it: where the surface
/// does not take the anchor on (it turns by more than 60 degrees a voxel, or ends in another sheet: an occluding part,
/// Höll et al. 2018, Fig. 3), it goes straight on with the normal that it has, off the surface. In a hollow edge it is
/// caught where its sample is no longer ahead.
///
/// False if the sample has slid off: the surface fell away from above it, or it is outside, by more than a voxel, where
/// the surface does not go on. The anchor has then gone straight, as if its face went on; the sample is to be let go. A
/// step that is not finite moves nothing.
[[nodiscard]] bool slide(const VoxelField& field, const Eigen::Vector3d& sample_O, const Eigen::Vector3d& step_O,
                         Anchor& anchor);

}  // namespace handhold::realtime
