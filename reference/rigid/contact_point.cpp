#include "reference/rigid/contact_point.hpp"

#include <Eigen/Geometry>

namespace handhold::reference::rigid {

Motion motion_of(const BodyState& body) {
  return {body.X_WO.R.normalized().toRotationMatrix(), body.X_WO.p, body.V_WO.w, body.V_WO.v};
}

ContactPoint contact_point(const RigidSupport& support, double t, const Motion& body) {
  const PathPoint s = at(support.motion, t);
  const Eigen::Vector3d rho = body.R * support.point_B;  // to the foot or the ball's centre
  const Proximity near = proximity(support.surface, body.p + rho - s.p);
  ContactPoint c;
  c.gap = near.distance - support.radius;
  c.gap_rate = near.normal.dot(body.v + body.w.cross(rho) - s.v);
  c.normal = near.normal;
  c.arm = rho - support.radius * near.normal;
  c.velocity = body.v + body.w.cross(c.arm) - s.v;
  c.slip = c.velocity - c.normal * c.normal.dot(c.velocity);
  c.surface_velocity = s.v;
  return c;
}

ContactRates contact_rates(const RigidSupport& support, double t, const Motion& body, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& angular_acceleration) {
  const PathPoint s = at(support.motion, t);
  const Eigen::Vector3d rho = body.R * support.point_B;
  const Proximity near = proximity(support.surface, body.p + rho - s.p);
  const Eigen::Vector3d rho_rate = body.w.cross(rho);
  const Eigen::Vector3d approach = body.v + rho_rate - s.v;
  const Eigen::Vector3d normal_rate = near.curvature * approach;
  const Eigen::Vector3d arm = rho - support.radius * near.normal;
  const Eigen::Vector3d arm_rate = rho_rate - support.radius * normal_rate;
  const Eigen::Vector3d center = a + angular_acceleration.cross(rho) + body.w.cross(rho_rate);
  return {near.normal.dot(center - s.a) + approach.dot(normal_rate),
          a + angular_acceleration.cross(arm) + body.w.cross(arm_rate) - s.a};
}

Tangents tangents(const Eigen::Vector3d& n) {
  int least = 0;
  n.cwiseAbs().minCoeff(&least);
  const Eigen::Vector3d a = Eigen::Vector3d::Unit(least).cross(n).normalized();
  return {a, n.cross(a)};
}

}  // namespace handhold::reference::rigid
