// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cases/model/voxel_field.hpp"

namespace handhold::realtime {

/// An anchor: a point of the object's surface with its outward normal, in O.
///
/// On a body with creases, and where voxels cannot tell, it lies on a triangle; on a smooth body on the zero of the
/// interpolated distance, whose normals do not show the facets.
struct Anchor {
  Eigen::Vector3d C_O{Eigen::Vector3d::Zero()};
  Eigen::Vector3d n_O{Eigen::Vector3d::Zero()};
  int face{-1};        ///< that it lies on; −1: on the smooth surface
  bool hollow{false};  ///< in a hollow edge or corner, where the normal turns with the pull: see turn_normal
};

/// The field's interpolated distance at a point, and its gradient by central differences over one voxel: continuous,
/// unlike that of the trilinear interpolant, whose jumps from cell to cell turn a normal by 10 degrees on a surface of
/// a few voxels' radius.
struct SmoothDistance {
  double distance{};
  Eigen::Vector3d gradient{Eigen::Vector3d::Zero()};
};
[[nodiscard]] SmoothDistance smooth_distance(const VoxelField& field, const Eigen::Vector3d& p_O);

/// The surface point nearest to `p_O`: exactly (triangles) from inside, however deep, where the nearest sheet is not
/// the one that the gradient of a thin wall points to, and on a body with creases; else along the field's gradient.
/// False (and `anchor` untouched) when p is outside beyond the band.
[[nodiscard]] bool foot(const VoxelField& field, const Eigen::Vector3d& p_O, Anchor& anchor);

/// How the normal of a touched place is taken.
enum class TouchNormal {
  smooth,  ///< on a smooth body that of the interpolated distance: a mesh's facets are not felt
  face,    ///< of the triangle: edges stay sharp to the last bit
};

/// Where a point that moves straight from `from_O` to `to_O` touches: at the first crossing of the surface from outside
/// (exact triangles), so that no wall is too thin; at the nearest surface point if it was inside already. False if it
/// ends outside without having crossed.
[[nodiscard]] bool find_touch(const VoxelField& field, const Eigen::Vector3d& from_O, const Eigen::Vector3d& to_O,
                              TouchNormal normal, Anchor& anchor);

/// What moves an anchor in a step, in O.
struct Slip {
  Eigen::Vector3d pull_O{Eigen::Vector3d::Zero()};  ///< p + (c/k) v at the end of the step: f* = k (pull − C)
  Eigen::Vector3d step_O{Eigen::Vector3d::Zero()};  ///< what friction lets it slip if the surface is flat [m]
  double mu{};                                      ///< μ_d
  double share{1};  ///< k / (k + c/h): of what f* exceeds friction by, over k, the implicit step slips so much
};

/// Slides an anchor along the surface by the law of docs/contact-law.md, "Edges and corners": on a smooth body voxel by
/// voxel, on one with creases from triangle to triangle. Over an edge it goes on in the nearer face, by what exceeds
/// friction there; in a hollow one it stays, or goes along it. So it slips less than `step`, or more, where the surface
/// turns.
///
/// False if nothing presses any more: the pull has come to point out of the body. The anchor is then where that was.
/// A step that is not finite moves nothing.
[[nodiscard]] bool slide(const VoxelField& field, const Slip& slip, Anchor& anchor);

/// Moves an anchor without friction to where the surface is nearest to `p_O`, of those places that it gets to downhill:
/// it stays on its sheet. False if p is no longer below it.
[[nodiscard]] bool follow(const VoxelField& field, const Eigen::Vector3d& p_O, Anchor& anchor);

/// Gives an anchor in a hollow edge or corner the normal against which `pull_O` − C presses there. Nothing changes if
/// the pull points out.
void turn_normal(const VoxelField& field, const Eigen::Vector3d& pull_O, Anchor& anchor);

}  // namespace handhold::realtime
