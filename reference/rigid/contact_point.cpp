// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/contact_point.hpp"

#include <Eigen/Geometry>

#include "cases/model/defect.hpp"

namespace handhold::reference::rigid {

Motion motion_of(const BodyState& body) {
  return {body.X_WO.R.normalized().toRotationMatrix(), body.X_WO.p, body.V_WO.w, body.V_WO.v};
}

ContactPoint contact_point(const RigidSupport& support, double t, const Motion& body) {
  const PathPoint s = at(support.motion, t);
  const TurnPoint turn = at(support.turn, t);
  const Eigen::Vector3d rho = body.R * support.point_B;  // to the foot or the ball's centre
  const Proximity near = proximity(support, t, body.p + rho);
  ContactPoint c;
  c.gap = near.distance - support.radius;
  c.gap_rate = near.normal.dot(body.v + body.w.cross(rho) - s.v - turn.w.cross(body.p + rho - s.p));
  c.normal = near.normal;
  c.arm = rho - DEFECT(ball_touches_at_its_centre, support.radius, 0.0) * near.normal;
  c.surface_velocity = s.v + turn.w.cross(body.p + c.arm - s.p);
  c.velocity = body.v + body.w.cross(c.arm) - c.surface_velocity;
  c.slip = c.velocity - c.normal * c.normal.dot(c.velocity);
  return c;
}

// Where the surface turns with w, its frame sees the centre at ρ_S = c − s approach with q = c' − s' − w × ρ_S and
// accelerate with c'' − s'' − α × ρ_S − w × (w × ρ_S) − 2 w × q (Coriolis); φ'' is the same in both frames.
ContactRates contact_rates(const RigidSupport& support, double t, const Motion& body, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& angular_acceleration) {
  const PathPoint s = at(support.motion, t);
  const TurnPoint turn = at(support.turn, t);
  const Eigen::Vector3d rho = body.R * support.point_B, from = body.p + rho - s.p;
  const Proximity near = proximity(support, t, body.p + rho);
  const Eigen::Vector3d rho_rate = body.w.cross(rho);
  const Eigen::Vector3d approach = body.v + rho_rate - s.v - turn.w.cross(from);
  const Eigen::Vector3d bend = near.curvature * approach;
  const Eigen::Vector3d arm = rho - support.radius * near.normal;
  const Eigen::Vector3d arm_rate =
      rho_rate - DEFECT(ball_rolls_on_a_plane, support.radius, 0.0) * (bend + turn.w.cross(near.normal));
  const Eigen::Vector3d center = a + angular_acceleration.cross(rho) + body.w.cross(rho_rate);
  const Eigen::Vector3d carried =
      turn.alpha.cross(from) + turn.w.cross(turn.w.cross(from) + DEFECT(half_of_coriolis, 2, 1) * approach);
  return {near.normal.dot(center - s.a - carried) + approach.dot(bend),
          a + angular_acceleration.cross(arm) + body.w.cross(arm_rate) - s.a - turn.alpha.cross(body.p + arm - s.p) -
              turn.w.cross(body.v + arm_rate - s.v)};
}

Tangents tangents(const Eigen::Vector3d& n) {
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d a = Eigen::Vector3d::Unit(least).cross(n).normalized();
  return {a, n.cross(a)};
}

}  // namespace handhold::reference::rigid
