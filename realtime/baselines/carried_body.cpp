// SPDX-License-Identifier: Apache-2.0
#include "realtime/baselines/carried_body.hpp"

#include <cmath>

#include "cases/model/defect.hpp"
#include "cases/model/rotation.hpp"

namespace handhold::realtime::baselines {
namespace {

using Eigen::Vector3d;

}  // namespace

CarriedBody::CarriedBody(const Body& body)
    : inertia_(body.inertia),
      moves_(body.mobility != Mobility::fixed),
      held_until_(body.held_until),
      X_WO_(body.X_WO),
      w_(body.V_WO.w) {
  v_ = body.V_WO.v + DEFECT(thrown_by_its_origin, 1.0, 0.0) * w_.cross(center() - X_WO_.p);
}

void CarriedBody::attach(const Pose& X_WF) {
  if (moves_) X_FO_ = X_WF.inverse() * X_WO_;
}

void CarriedBody::follow(const Pose& X_WF, double dt) {
  const Vector3d before = center();
  const Eigen::Quaterniond R = X_WO_.R;
  X_WO_ = X_WF * *X_FO_;
  X_WO_.R.normalize();
  if (!(dt > 0)) return;
  v_ = (center() - before) / dt;
  w_ = rotation_vector(X_WO_.R * R.conjugate()) / dt;
}

void CarriedBody::fly(const Vector3d& gravity, double t, double dt) {
  if (!moves_) return;
  if (t <= held_until_) {
    v_.setZero();
    w_.setZero();
    return;
  }
  const Vector3d c = center() + dt * v_ + dt * dt / 2 * gravity;
  v_ += dt * gravity;
  const double angle = dt * w_.norm();
  if (angle > 0) X_WO_.R = (Eigen::Quaterniond(Eigen::AngleAxisd(angle, w_.normalized())) * X_WO_.R).normalized();
  X_WO_.p = c - X_WO_.R * inertia_.center;
}

BodyState CarriedBody::state() const { return {X_WO_, {w_, v_ + w_.cross(X_WO_.p - center())}}; }

double CarriedBody::kinetic() const {
  const Vector3d w_O = X_WO_.R.conjugate() * w_;
  return 0.5 * inertia_.mass * v_.squaredNorm() + 0.5 * w_O.dot(inertia_.about_center * w_O);
}

double CarriedBody::height(const Vector3d& gravity) const { return -gravity.dot(center()); }

}  // namespace handhold::realtime::baselines
