// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cases/model/face_graph.hpp"

namespace handhold::realtime {

/// Where on a mesh a point lies: in a face, on one of its sides, or at one of its corners.
struct Place {
  int face{-1};
  int side{-1};    ///< of `face`
  int corner{-1};  ///< of `face`
};

/// The place of a point of face `face`, which is on a side or at a corner if that is nearer than `eps` [m].
[[nodiscard]] Place place_of(const FaceGraph& faces, int face, const Eigen::Vector3d& p_O, double eps);

/// Whether the surface is hollow at a place, so that an anchor can be caught there: at a hollow edge, or at an end of
/// one.
[[nodiscard]] bool is_hollow(const FaceGraph& faces, const Place& place);

/// Of the faces that meet at a place, the one whose normal is nearest to n.
[[nodiscard]] int face_along(const FaceGraph& faces, const Place& place, const Eigen::Vector3d& n_O);

/// A spring's pull on an anchor, split by the tangent cone T of the outside: w is the point of T nearest to it
/// (docs/contact-law.md, "Edges and corners").
struct Pull {
  Eigen::Vector3d w{Eigen::Vector3d::Zero()};  ///< along the surface
  Eigen::Vector3d n{Eigen::Vector3d::Zero()};  ///< unit, outward: against what presses
  double depth{};                              ///< |pull − w| >= 0; negative: the pull points out, nothing presses
  Place place{};                               ///< the face that w leads into, and its side if w runs along that
};

/// T is bounded by the fan of faces that meet at `place`; for a pull into the body w is the fan's nearest point. Ties,
/// as of a pull that bisects a convex edge, go to the first face.
[[nodiscard]] Pull split(const FaceGraph& faces, const Place& place, const Eigen::Vector3d& pull);

}  // namespace handhold::realtime
