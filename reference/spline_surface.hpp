// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "cases/model/voxel_field.hpp"
#include "reference/surface.hpp"

namespace handhold::reference {

/// Value and first two derivatives of the distance spline.
struct SurfaceSample {
  double value{};                                     ///< [m], < 0 inside
  Eigen::Vector3d gradient{Eigen::Vector3d::Zero()};  ///< [1]
  Eigen::Matrix3d hessian{Eigen::Matrix3d::Zero()};   ///< [1/m]
};

/// C2 tricubic B-spline through the node distances of a VoxelField; its zero set is the surface the reference slides
/// on.
///
/// Exact for planes (natural ends); order 4 in the voxel size where the distance is smooth; edges are rounded over one
/// or two voxels. The prefilter forgets a disturbance by 2 − √3 = 0.27 a voxel, so that the clamp of the field at
/// ±band, at least 12 voxels away, moves the surface by less than 1e-7 voxels. Off the grid: VoxelField::distance.
class SplineSurface : public Surface {
 public:
  /// Throws InputError for a band of less than 12 voxels or a grid of less than 4 nodes a side.
  explicit SplineSurface(std::shared_ptr<const VoxelField> field);

  [[nodiscard]] double value(const Eigen::Vector3d& p_O) const override;
  [[nodiscard]] SurfaceSample evaluate(const Eigen::Vector3d& p_O) const;  ///< with the Hessian
  [[nodiscard]] SurfaceSample gradient(const Eigen::Vector3d& p_O) const;  ///< Hessian left zero

  /// The zero of the spline near `p_O`, by Newton's method along the gradient; for points within a few voxels.
  [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& p_O) const;

  /// The closest surface point of any point: (p_O − foot) is parallel to the normal at the foot.
  [[nodiscard]] Foot foot(const Eigen::Vector3d& p_O) const override;
  [[nodiscard]] Foot foot_on_sheet(const Eigen::Vector3d& p_O, const Place& anchor) const override {
    return foot_from(p_O, anchor.p_O);
  }

  [[nodiscard]] AnchorSurface at(const Eigen::Vector3d& anchor_O, const Foothold&, bool with_curvature) const override;
  [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& p_O, const Foothold&) const override {
    return project(p_O);
  }

  [[nodiscard]] double band() const override { return field_->band(); }

 private:
  template <int Derivatives>
  [[nodiscard]] SurfaceSample sample(const Eigen::Vector3d& p_O) const;
  [[nodiscard]] bool on_grid(const Eigen::Vector3d& node) const;
  [[nodiscard]] Eigen::Vector3d nearby_surface_point(const Eigen::Vector3d& p_O) const;
  [[nodiscard]] Foot foot_from(const Eigen::Vector3d& p_O, const Eigen::Vector3d& start_O) const;

  std::shared_ptr<const VoxelField> field_;
  Eigen::Vector3i size_;              // of the padded array: one ghost coefficient on each side
  std::vector<double> coefficients_;  // x fastest
};

}  // namespace handhold::reference
