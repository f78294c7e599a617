#include "realtime/rigid_body.hpp"

#include <cmath>

namespace handhold::realtime {

RigidBody make_rigid_body(const Body& body) {
  RigidBody rigid;
  rigid.mass = body.inertia.mass;
  rigid.center_O = body.inertia.center;
  rigid.inertia_O = body.inertia.about_center;
  rigid.mobility = body.mobility;
  rigid.held_until = body.held_until;
  rigid.X_WO = body.X_WO;
  if (body.mobility == Mobility::fixed || body.held_until > 0) return rigid;
  if (body.mobility == Mobility::free) rigid.w = body.V_WO.w;
  rigid.v = body.V_WO.v + rigid.w.cross(rigid.center() - rigid.X_WO.p);
  return rigid;
}

Matrix6 mass_matrix(const RigidBody& body) {
  Matrix6 M = Matrix6::Zero();
  M.topLeftCorner<3, 3>() = body.mass * Eigen::Matrix3d::Identity();
  M.bottomRightCorner<3, 3>() = body.inertia();
  return M;
}

Vector6 external_force(const RigidBody& body, const Eigen::Vector3d& gravity) {
  Vector6 F;
  const Eigen::Vector3d spin = body.inertia() * body.w;
  F << body.mass * gravity, -body.w.cross(spin);
  return F;
}

void move(RigidBody& body, const Vector6& velocity, double h) {
  body.v = velocity.head<3>();
  body.w = velocity.tail<3>();
  const Eigen::Vector3d center = body.center() + h * body.v;
  const double speed = body.w.norm();
  if (speed > 0) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(h * speed, body.w / speed));
    body.X_WO.R = (turn * body.X_WO.R).normalized();
  }
  body.X_WO.p = center - body.X_WO.R * body.center_O;
}

}  // namespace handhold::realtime
