// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "cases/model/face_graph.hpp"
#include "reference/foothold.hpp"

namespace handhold::reference {

/// The contact law at the edges and corners of a closed mesh. Immutable.
class Polyhedron {
 public:
  /// `faces` must outlive it.
  explicit Polyhedron(const FaceGraph& faces);

  [[nodiscard]] const Face& face(int i) const { return graph_[i]; }
  [[nodiscard]] int count() const { return graph_.size(); }

  /// A triangle, or in place of one without area the nearest to p of the faces that it shares a corner with.
  [[nodiscard]] int with_area(int triangle, const Eigen::Vector3d& p) const;

  /// By how much the edge at a side turns: > 0 convex, < 0 hollow [rad]; 0 where nothing lies beyond it.
  [[nodiscard]] double turn(int face, int side) const;

  /// The largest |turn| of all edges [rad].
  [[nodiscard]] double sharpest() const;

  [[nodiscard]] bool has_creases() const { return graph_.crease_count() > 0; }
  [[nodiscard]] bool convex_crease(int face, int side) const {
    return graph_[face].edge[std::size_t(side)] == EdgeKind::convex;
  }

  /// The side that a point in the plane of a face is farthest out of, or least inside.
  [[nodiscard]] int farthest_side(int face, const Eigen::Vector3d& p) const;

  /// How far p is out of a face beyond a side [m], < 0 inside; p is taken to lie in its plane.
  [[nodiscard]] double outside(int face, int side, const Eigen::Vector3d& p) const {
    return -graph_[face].inside(std::size_t(side), p);
  }

  /// The point of a side nearest to p.
  [[nodiscard]] Eigen::Vector3d on_side(int face, int side, const Eigen::Vector3d& p) const;

  /// What of its face a point lies on, to within `reach` [m]: one of its corners, one of its sides, or its inside.
  [[nodiscard]] Foothold feature(const Eigen::Vector3d& p, int face, double reach) const;

  /// The projection of f on the tangent cone of the outside at an edge or corner.
  [[nodiscard]] Way way(const Eigen::Vector3d& f, const Foothold& hold) const;

  /// The same, at an edge, for an anchor that slides along it: continued smoothly where f leads off the edge.
  [[nodiscard]] Way along_edge(const Eigen::Vector3d& f, const Foothold& hold) const;

 private:
  class Nearest;

  [[nodiscard]] Eigen::Vector3d direction(int face, int side) const;
  [[nodiscard]] Eigen::Vector3d edge_normal(int face, int side) const;
  [[nodiscard]] int side_from(int face, int corner) const;

  const FaceGraph& graph_;
  std::vector<Eigen::Vector3d> corner_normal_;  // of every vertex: angle weighted, its sign tells in from out
};

}  // namespace handhold::reference
