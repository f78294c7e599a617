// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "reference/surface.hpp"

namespace handhold::reference {

/// The exact triangles.
///
/// An anchor stays on the face it touched. In slip it moves in the face's plane; when it runs over the border, that is
/// an event of its own, and it goes on
/// - across a flat or convex edge: on the next face, with that face's normal. Its depth there is smaller, so where the
///   edge is sharp (tan of the turn > 1 / mu_d in the direction of sliding) the contact is released; round a blunt one
///   it goes over, and an undamped lag, now outside the cone, slips at once to where it is on it again;
/// - at a hollow edge: it is caught there (`Wedge`).
/// A corner is passed as one edge after the other. These are the limits of edges rounded with a radius that goes to 0.
/// What is in stick does not look at borders.
class MeshSurface : public Surface {
 public:
  explicit MeshSurface(std::shared_ptr<const VoxelField> field);

  [[nodiscard]] double value(const Eigen::Vector3d& p_O) const override;
  [[nodiscard]] Foot foot(const Eigen::Vector3d& p_O) const override;
  [[nodiscard]] AnchorSurface at(const Eigen::Vector3d& anchor_O, const Foothold& hold,
                                 bool with_curvature) const override;
  [[nodiscard]] Eigen::Vector3d project(const Eigen::Vector3d& p_O, const Foothold& hold) const override;
  [[nodiscard]] double overrun(const Eigen::Vector3d& anchor_O, const Foothold& hold) const override;
  [[nodiscard]] Foothold beyond(const Eigen::Vector3d& anchor_O, const Foothold& hold) const override;
  [[nodiscard]] Wedge wedge(const Foothold& hold) const override;
  [[nodiscard]] double band() const override { return field_->band(); }

 private:
  struct Face {
    std::array<Eigen::Vector3d, 3> corner;  ///< side i runs from corner i to corner i + 1
    Eigen::Vector3d n;                      ///< zero: without area, nothing rests on it
    std::array<Eigen::Vector3d, 3> out;     ///< of every side: unit, in the plane, out of the face
    std::array<int, 3> neighbour{-1, -1, -1};
  };

  void join_neighbours();
  [[nodiscard]] const Face& face(int i) const { return faces_[std::size_t(i)]; }
  [[nodiscard]] static double outside(const Face& face, int side, const Eigen::Vector3d& p);
  [[nodiscard]] static int farthest_side(const Face& face, const Eigen::Vector3d& p);
  [[nodiscard]] int side_towards(int from, int to) const;
  [[nodiscard]] bool hollow(int from, int side) const;
  [[nodiscard]] Foothold search_beyond(const Eigen::Vector3d& anchor, int from, int side) const;

  std::shared_ptr<const VoxelField> field_;
  std::vector<Face> faces_;
  double diagonal_{};  // of everything [m]
};

}  // namespace handhold::reference
