// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/edge.hpp"

#include <algorithm>
#include <cmath>

namespace handhold::closed_form {

double leaves_convex_edge(const EdgeContact& c, double depth, double turn, double speed) {
  return std::max(c.friction.mu_dynamic * depth, depth / std::tan(turn) - c.damping * speed / c.stiffness);
}

Eigen::Vector2d pressed(const EdgeContact& c, double depth, double tilt) {
  const double slope = std::tan(tilt);
  return -c.stiffness * depth * Eigen::Vector2d(slope <= c.friction.mu_static ? slope : c.friction.mu_dynamic, 1);
}

Eigen::Vector3d held(const EdgeContact& c, const Eigen::Vector3d& reach) { return c.stiffness * reach; }

double leaves_hollow_edge(const EdgeContact& c, double depth, double speed) {
  return c.friction.mu_static * depth - c.damping * speed / c.stiffness;
}

double drag(const EdgeContact& c, double depth) { return c.friction.mu_dynamic * c.stiffness * depth; }

double groove_drag(const EdgeContact& c, double depth1, double depth2) { return drag(c, std::hypot(depth1, depth2)); }

}  // namespace handhold::closed_form
