// SPDX-License-Identifier: Apache-2.0
#include "realtime/rigid_body.hpp"

#include <cmath>

#include <Eigen/LU>

namespace handhold::realtime {

RigidBody make_rigid_body(const Body& body) {
  RigidBody rigid;
  rigid.mass = body.inertia.mass;
  rigid.center_O = body.inertia.center;
  rigid.inertia_O = body.inertia.about_center;
  rigid.inverse_inertia_O = body.inertia.about_center.inverse();
  rigid.mobility = body.mobility;
  rigid.held_until = body.held_until;
  rigid.X_WO = body.X_WO;
  const Eigen::AlignedBox3d bounds = body.field->bounds();
  rigid.radius = (bounds.max() - rigid.center_O).cwiseAbs().cwiseMax((bounds.min() - rigid.center_O).cwiseAbs()).norm();
  if (body.mobility == Mobility::fixed) return rigid;
  if (body.mobility == Mobility::free) rigid.w = body.V_WO.w;
  rigid.v = body.V_WO.v + rigid.w.cross(rigid.center() - rigid.X_WO.p);
  return rigid;
}

Eigen::Quaterniond rotation_by(const Eigen::Vector3d& angle) {
  const double size = angle.norm();
  const bool turns = size > 1e-9;  // below, the cosine is 1 to the last bit
  const double scale = turns ? std::sin(0.5 * size) / size : 0.5;
  Eigen::Quaterniond q;
  q.w() = turns ? std::cos(0.5 * size) : 1;
  q.vec() = scale * angle;
  return q;
}

}  // namespace handhold::realtime
