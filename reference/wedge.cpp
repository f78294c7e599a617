// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/wedge.hpp"

#include <algorithm>

#include <Eigen/Geometry>

#include "cases/model/defect.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;

/// > 0 when the force on the object, k r + c v, is outside the cone of a face and points away from the edge [N].
double leaves(const Element& element, const Approach& approach, const Vector3d& n, const Vector3d& away) {
  const Vector3d force = element.stiffness * approach.r + element.damping * approach.v;
  const double normal_force = -force.dot(n);
  const Vector3d tangential = force + normal_force * n;
  return std::min(tangential.norm() - element.friction.mu_static * normal_force, tangential.dot(away));
}

}  // namespace

Vector3d Wedge::normal(const Vector3d& r) const {
  const Vector3d edge = n[0].cross(n[1]).normalized();
  const Vector3d out = -(r - r.dot(edge) * edge);
  const double from_first = n[0].cross(out).dot(edge), to_second = out.cross(n[1]).dot(edge);
  if (DEFECT(wedge_or, from_first > 0 && to_second > 0, from_first > 0 || to_second > 0)) return out.normalized();
  return out.dot(n[0]) >= out.dot(n[1]) ? n[0] : n[1];
}

Response respond(const Element& element, const Approach& approach, const Wedge& wedge) {
  AnchorSurface surface;
  surface.n = wedge.normal(approach.r);
  Response response = respond(element, Mode::stick, approach, surface);
  response.friction = std::max(leaves(element, approach, wedge.n[0], wedge.away[0]),
                               leaves(element, approach, wedge.n[1], wedge.away[1]));
  return response;
}

int way_out(const Element& element, const Approach& approach, const Wedge& wedge) {
  return leaves(element, approach, wedge.n[0], wedge.away[0]) >= leaves(element, approach, wedge.n[1], wedge.away[1])
             ? 0
             : 1;
}

}  // namespace handhold::reference
