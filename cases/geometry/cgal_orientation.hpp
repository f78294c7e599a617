// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace handhold {

/// Sign of the signed area of (a, b, c) in the plane of its first two coordinates: 1 counter-clockwise, 0 collinear.
/// Exact (CGAL's filtered predicates), for coordinates that are finite. Plain types: CGAL's flags must not reach other
/// files.
[[nodiscard]] int exact_orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

/// Sign of (d − a)·((b − a) × (c − a)): 1 if d lies on the side the normal of (a, b, c) points to, 0 in its plane.
/// Exact.
[[nodiscard]] int exact_orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                    const Eigen::Vector3d& d);

}  // namespace handhold
