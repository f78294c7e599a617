// SPDX-License-Identifier: Apache-2.0
#include "realtime/paper/host.hpp"

#include <string>
#include <utility>

#include "cases/model/input_error.hpp"

namespace handhold::realtime::paper {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Acceleration {
  Vector3d linear, angular;
};

Acceleration acceleration(const HostBody& body, const Vector3d& gravity, const Wrench& wrench) {
  if (body.mobility == Mobility::translation) return {wrench.force / body.mass + gravity, Vector3d::Zero()};
  const Matrix3d R = body.motion.X_WO.R.toRotationMatrix();
  const Matrix3d inertia = R * body.inertia_O * R.transpose();
  const Vector3d torque = wrench.torque - body.motion.w.cross(inertia * body.motion.w);
  return {wrench.force / body.mass + gravity, inertia.ldlt().solve(torque)};
}

/// Moves the centre of mass by `step` and turns by the rotation vector `turn`.
void displace(HostBody& body, const Vector3d& step, const Vector3d& turn) {
  Pose& X_WO = body.motion.X_WO;
  const double angle = turn.norm();
  if (angle == 0) {
    X_WO.p += step;
    return;
  }
  const Vector3d center = X_WO * body.center_O + step;
  X_WO.R = (Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) * X_WO.R).normalized();
  X_WO.p = center - X_WO.R * body.center_O;
}

void integrate(HostBody& body, const Acceleration& a, double h, Integrator integrator) {
  BodyMotion& m = body.motion;
  const Vector3d v = m.v, w = m.w;
  m.v += h * a.linear;
  m.w += h * a.angular;
  if (integrator == Integrator::semi_implicit) return displace(body, h * m.v, h * m.w);
  if (integrator == Integrator::explicit_euler) return displace(body, h * v, h * w);
  displace(body, h * v + h * h / 2 * a.linear, h * w + h * h / 2 * a.angular);
}

Wrench sum(const Wrench& a, const Wrench& b) { return {a.force + b.force, a.torque + b.torque}; }

}  // namespace

Host::Host(Middleware middleware, const HostBody& body, const Vector3d& gravity, const HostOptions& options)
    : middleware_(std::move(middleware)), body_(body), gravity_(gravity), options_(options), old_(body.motion) {
  validate(options);
  if (!(body.mass > 0)) throw InputError("host body: the mass must be above 0 (give one in kg)");
}

void Host::advance(double dt, std::span<const Pose> X_WP, const Wrench& applied) {
  const BodyMotion now = body_.motion;
  Wrench wrench = middleware_.frame(dt, X_WP, options_.old_pose ? old_ : now);
  old_ = now;
  const double h = dt / options_.substeps;
  for (int i = 0; i < options_.substeps; ++i) {
    if (i > 0 && !options_.hold_force) wrench = middleware_.wrench_at(body_.motion);
    if (body_.mobility != Mobility::fixed)
      integrate(body_, acceleration(body_, gravity_, sum(wrench, applied)), h, options_.integrator);
  }
  t_ += dt;
}

}  // namespace handhold::realtime::paper
