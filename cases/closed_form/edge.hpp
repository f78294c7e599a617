// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// One sample of the L2 element at an edge or corner of a body that does not move (docs/contact-law.md, "Edges and
/// corners"). Forces are those on the body. Exact for every motion that is slow at the instant that is named; where a
/// speed matters to first order it is an argument.
struct EdgeContact {
  double stiffness{100};  ///< k [N/m]
  double damping{0.05};   ///< c [N s/m]
  Friction friction{};
};

/// A sample dragged at `depth` d over the face z = 0 towards the convex edge x = 0, whose second face turns down by
/// `turn` a in (0, π) [rad]: how far beyond the edge it is when its contact ends, x = max(μ_d d, d cot a − c V / k)
/// [m], with V = `speed` along x then.
///
/// Up to μ_d d the anchor lags on the first face. At the edge f* = (k x + c V, −k d) either points out of the second
/// face, or the anchor goes down that face until the sample is above it.
[[nodiscard]] double leaves_convex_edge(const EdgeContact& contact, double depth, double turn, double speed = 0);

/// A sample pressed into the face z = 0 in a straight line, tilted by `tilt` in [0, π/2) from −z towards −x, at rest at
/// `depth` d: its force (x, z) = k d (−min(tan tilt, μ_d), −1) if it slid, k d (−tan tilt, −1) if tan tilt <= μ_s [N].
/// Both hold from the first instant on, because a touch begins with no lag. How near a convex edge at x >= 0 is does
/// not matter.
[[nodiscard]] Eigen::Vector2d pressed(const EdgeContact& contact, double depth, double tilt);

/// Of a sample that sticks, at p − C = `reach` and at rest, wherever the faces around C end: k (p − C) [N]. So it is
/// for one held in a hollow edge or corner, with C there.
[[nodiscard]] Eigen::Vector3d held(const EdgeContact& contact, const Eigen::Vector3d& reach);

/// A sample held in a hollow right-angled edge x = z = 0 (outside x > 0 and z > 0), drawn out along +x at depth d: how
/// far in front of the wall it is when it breaks away, x = μ_s d − c V / k [m].
[[nodiscard]] double leaves_hollow_edge(const EdgeContact& contact, double depth, double speed = 0);

/// Friction on a sample that slides along a face at depth d: μ_d k d [N]; along a hollow edge at depths d1 and d2 in
/// both faces' normal directions: μ_d k sqrt(d1² + d2²), the limit of a fillet of vanishing radius. The lag of its
/// anchor is the same divided by k [m].
[[nodiscard]] double drag(const EdgeContact& contact, double depth);
[[nodiscard]] double groove_drag(const EdgeContact& contact, double depth1, double depth2);

}  // namespace handhold::closed_form
