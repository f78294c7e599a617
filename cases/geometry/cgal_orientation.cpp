// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/geometry/cgal_orientation.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace handhold {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 point(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }
Kernel::Point_3 point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

int exact_orientation(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c)));
}

int exact_orientation(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                      const Eigen::Vector3d& d) {
  return static_cast<int>(CGAL::orientation(point(a), point(b), point(c), point(d)));
}

}  // namespace handhold
