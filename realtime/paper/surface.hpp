// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include <Eigen/Core>

#include "cases/model/voxel_field.hpp"
#include "realtime/paper/options.hpp"

namespace handhold::realtime::paper {

/// A point of an object's surface with its outward unit normal, in O. An anchor is one.
struct Spot {
  Eigen::Vector3d C_O{Eigen::Vector3d::Zero()};
  Eigen::Vector3d n_O{Eigen::Vector3d::UnitZ()};
};

/// All the paper's law asks of a shape ("scene queries such as raycasts", section 3.5). Implementations do not allocate
/// in a query and may be asked from any thread.
class Surface {
 public:
  virtual ~Surface() = default;

  /// First hit of the straight way from `from_O` to `to_O`; none if it meets nothing.
  [[nodiscard]] virtual std::optional<Spot> cast(const Eigen::Vector3d& from_O, const Eigen::Vector3d& to_O) const = 0;

  /// The closest surface point, inside or outside, at most `reach` [m] away.
  [[nodiscard]] virtual std::optional<Spot> closest(const Eigen::Vector3d& p_O, double reach) const = 0;
};

/// The half space z <= height: exact, for closed forms.
class PlaneSurface : public Surface {
 public:
  explicit PlaneSurface(double height = 0) : height_(height) {}
  [[nodiscard]] std::optional<Spot> cast(const Eigen::Vector3d& from_O, const Eigen::Vector3d& to_O) const override;
  [[nodiscard]] std::optional<Spot> closest(const Eigen::Vector3d& p_O, double reach) const override;

 private:
  double height_;
};

/// A slab |x| <= half_width, endless along y and z: what two fingers pinch.
class SlabSurface : public Surface {
 public:
  explicit SlabSurface(double half_width) : half_(half_width) {}
  [[nodiscard]] std::optional<Spot> cast(const Eigen::Vector3d& from_O, const Eigen::Vector3d& to_O) const override;
  [[nodiscard]] std::optional<Spot> closest(const Eigen::Vector3d& p_O, double reach) const override;

 private:
  double half_;
};

/// A ball of `radius` about the origin of O: exact.
class SphereSurface : public Surface {
 public:
  explicit SphereSurface(double radius) : radius_(radius) {}
  [[nodiscard]] std::optional<Spot> cast(const Eigen::Vector3d& from_O, const Eigen::Vector3d& to_O) const override;
  [[nodiscard]] std::optional<Spot> closest(const Eigen::Vector3d& p_O, double reach) const override;

 private:
  double radius_;
};

/// An object's voxel field as a surface.
class FieldSurface : public Surface {
 public:
  FieldSurface(std::shared_ptr<const VoxelField> field, Normals normals)
      : field_(std::move(field)), normals_(normals) {}
  [[nodiscard]] std::optional<Spot> cast(const Eigen::Vector3d& from_O, const Eigen::Vector3d& to_O) const override;
  [[nodiscard]] std::optional<Spot> closest(const Eigen::Vector3d& p_O, double reach) const override;

 private:
  [[nodiscard]] Eigen::Vector3d face_normal(int triangle, const Eigen::Vector3d& instead) const;
  [[nodiscard]] Eigen::Vector3d smooth(const Eigen::Vector3d& p_O, const Eigen::Vector3d& instead) const;

  std::shared_ptr<const VoxelField> field_;
  Normals normals_;
};

/// The surface that a problem describes.
[[nodiscard]] std::shared_ptr<const Surface> make_surface(const printed::Shape& shape);

}  // namespace handhold::realtime::paper
