// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "cases/model/voxel_field.hpp"
#include "reference/element.hpp"
#include "reference/foothold.hpp"
#include "reference/reference.hpp"

namespace handhold::reference {

/// The surface point below a point, with the outward normal there.
struct Foot {
  Eigen::Vector3d p_O{Eigen::Vector3d::Zero()};  ///< on the surface [m]
  Eigen::Vector3d n_O{Eigen::Vector3d::Zero()};  ///< unit
  double depth{};                                ///< −(point − p_O)·n_O [m]
  Foothold hold{};
};

/// What contacts need of the surface of an object, in its frame O. Immutable. Smooth surfaces have no edges, and the
/// functions on edges and corners keep their defaults.
class Surface {
 public:
  virtual ~Surface() = default;

  /// Signed distance, < 0 inside [m]: exact in sign everywhere, in size near the surface only.
  [[nodiscard]] virtual double value(const Eigen::Vector3d& p_O) const = 0;

  /// The closest surface point of any point.
  [[nodiscard]] virtual Foot foot(const Eigen::Vector3d& p_O) const = 0;

  /// The point below `p_O` on the sheet that an anchor is on: where the anchor would follow to without friction.
  [[nodiscard]] virtual Foot foot_on_sheet(const Eigen::Vector3d& p_O, const Place& anchor) const = 0;

  /// The surface at an anchor that is free on its foothold.
  [[nodiscard]] virtual AnchorSurface at(const Eigen::Vector3d& anchor_O, const Foothold& hold,
                                         bool with_curvature) const = 0;

  /// Moves a point that is nearly there onto the foothold: along the normal, or to the edge or corner.
  [[nodiscard]] virtual Eigen::Vector3d project(const Eigen::Vector3d& p_O, const Foothold& hold) const = 0;

  /// How far within (< 0) or beyond (> 0) the border of its face, or the ends of its edge, an anchor is [m].
  [[nodiscard]] virtual double overrun(const Eigen::Vector3d&, const Foothold&) const { return -1; }

  /// The edge or corner that an anchor which has overrun its face or edge is at; where that has no other side, the face
  /// that lies a little farther.
  [[nodiscard]] virtual Place border(const Place& anchor) const { return anchor; }

  /// The law at a foothold that is caught, for a pull f* [N].
  [[nodiscard]] virtual Way way(const Eigen::Vector3d&, const Foothold&) const { return {}; }

  /// The same for an anchor that slides along an edge.
  [[nodiscard]] virtual Way along_edge(const Eigen::Vector3d&, const Foothold&) const { return {}; }

  /// c = 0: where an anchor that is off its cone jumps to, over faces, edges and corners: |w| = mu N, or at rest in a
  /// hollow edge or corner, or the last place before it is released. Nothing on a smooth surface.
  [[nodiscard]] virtual std::optional<Place> slide(const Eigen::Vector3d&, const Place&, double) const { return {}; }

  /// The convex crease, or the corner at the end of one, that a point of the surface is on to within `reach` [m]; one
  /// that holds nothing if there is none.
  [[nodiscard]] virtual Foothold convex_crease(const Foot&, double) const { return {}; }

  /// Whether another sheet is as near to p as its foot, to within `reach` [m].
  [[nodiscard]] virtual bool between_sheets(const Eigen::Vector3d&, const Foot&, double) const { return false; }

  /// Distances are known up to here on both sides [m].
  [[nodiscard]] virtual double band() const = 0;
};

/// Which surface a body gets, and why.
struct SurfaceChoice {
  SurfaceModel model{};
  std::string why{};
};

/// `automatic` is the triangles for a body with creases, the spline for one without.
[[nodiscard]] SurfaceChoice choose_surface(const VoxelField& field, SurfaceModel wanted);

/// The surface of `field`, by choose_surface; throws InputError if the field is not fit for it.
[[nodiscard]] std::shared_ptr<const Surface> make_surface(std::shared_ptr<const VoxelField> field, SurfaceModel model);

}  // namespace handhold::reference
