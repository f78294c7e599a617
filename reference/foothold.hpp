// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace handhold::reference {

/// The piece of a surface that an anchor is on, decided at touch; smooth surfaces are one piece.
struct Foothold {
  int face{-1};    ///< triangle
  int side{-1};    ///< the anchor is held by the edge at this side of `face`; −1: by no edge
  int corner{-1};  ///< the anchor is held by this vertex of the mesh; −1: by no corner

  [[nodiscard]] bool caught() const { return side >= 0 || corner >= 0; }
  [[nodiscard]] friend bool operator==(const Foothold& a, const Foothold& b) {
    return a.face == b.face && a.side == b.side && a.corner == b.corner;
  }
};

/// The pull f* = k (p − C) + c v of a sample, split at its anchor's edge or corner by the tangent cone T of the outside
/// (docs/contact-law.md): f* = w − N n, w the point of T nearest to f*.
struct Way {
  Eigen::Vector3d w{Eigen::Vector3d::Zero()};  ///< where the pull would move the anchor [N]
  Eigen::Vector3d n{Eigen::Vector3d::Zero()};  ///< unit, outward
  double N{};  ///< normal force [N]; <= 0: f* lies in T, at that distance from its boundary, and w is on the boundary
  Foothold hold{};                                ///< what w leads along: a face, an edge, or (w = 0) the corner
  Eigen::Vector3d edge{Eigen::Vector3d::Zero()};  ///< of a slide along an edge: its direction, unit
  double leaves{-1};                              ///< of a slide along an edge: > 0 when f* leads off onto a face [N]
  double rival{};  ///< how much farther the next way is that is another one [N]; 0: the law does not decide
};

/// An anchor and what it is on.
struct Place {
  Eigen::Vector3d p_O{Eigen::Vector3d::Zero()};
  Foothold hold{};
};

}  // namespace handhold::reference
