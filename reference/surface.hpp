// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <Eigen/Core>

#include "cases/model/voxel_field.hpp"
#include "reference/element.hpp"
#include "reference/reference.hpp"
#include "reference/wedge.hpp"

namespace handhold::reference {

/// The piece of a surface that an anchor is on, decided at touch; smooth surfaces are one piece.
struct Foothold {
  int face{-1};  ///< triangle
  int wall{-1};  ///< the triangle beyond a hollow edge, if the anchor is caught in that edge; −1: it is free on `face`

  [[nodiscard]] bool caught() const { return wall >= 0; }
  [[nodiscard]] friend bool operator==(const Foothold& a, const Foothold& b) {
    return a.face == b.face && a.wall == b.wall;
  }
};

/// The surface point below a point, with the outward normal there.
struct Foot {
  Eigen::Vector3d p_O{Eigen::Vector3d::Zero()};  ///< on the surface [m]
  Eigen::Vector3d n_O{Eigen::Vector3d::Zero()};  ///< unit
  double depth{};                                ///< −(point − p_O)·n_O [m]
  Foothold hold{};
};

/// What contacts need of the surface of an object, in its frame O. Immutable.
class Surface {
 public:
  virtual ~Surface() = default;

  /// Signed distance, < 0 inside [m]: exact in sign everywhere, in size near the surface only.
  [[nodiscard]] virtual double value(const Eigen::Vector3d& p_O) const = 0;

  /// The closest surface point of any point.
  [[nodiscard]] virtual Foot foot(const Eigen::Vector3d& p_O) const = 0;

  /// The surface at an anchor that is free on its foothold.
  [[nodiscard]] virtual AnchorSurface at(const Eigen::Vector3d& anchor_O, const Foothold& hold,
                                         bool with_curvature) const = 0;

  /// Moves a point that is nearly there onto the foothold: along the normal, or to the hollow edge.
  [[nodiscard]] virtual Eigen::Vector3d project(const Eigen::Vector3d& p_O, const Foothold& hold) const = 0;

  /// How far within (< 0) or beyond (> 0) the border of its face an anchor is [m].
  [[nodiscard]] virtual double overrun(const Eigen::Vector3d&, const Foothold&) const { return -1; }

  /// Where an anchor that has overrun its face goes on: free on the next face, or caught in a hollow edge.
  [[nodiscard]] virtual Foothold beyond(const Eigen::Vector3d&, const Foothold& hold) const { return hold; }

  /// Of a foothold that is caught.
  [[nodiscard]] virtual Wedge wedge(const Foothold&) const { return {}; }

  /// Distances are known up to here on both sides [m].
  [[nodiscard]] virtual double band() const = 0;
};

/// The surface of `field` that `model` names; throws InputError if the field is not fit for it.
[[nodiscard]] std::shared_ptr<const Surface> make_surface(std::shared_ptr<const VoxelField> field, SurfaceModel model);

}  // namespace handhold::reference
