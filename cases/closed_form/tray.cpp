// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/tray.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace handhold::closed_form {
namespace {

using Eigen::Vector3d;

std::array<Vector3d, 4> places(const Tray& t) {
  return {Vector3d{t.a, t.b, 0}, Vector3d{t.a, -t.b, 0}, Vector3d{-t.a, t.b, 0}, Vector3d{-t.a, -t.b, 0}};
}

/// Rotation of the tray at rest: k Σ (R c_i) × c_i = m g (R r) × z, both about the middle of the underside.
Eigen::Quaterniond lean(const Tray& t) {
  const Vector3d weight{0, 0, -t.mass * t.gravity}, center{t.x, t.y, t.height};
  // Torque per angle of the four springs about x, y, z; the weight changes it by m g h only, so this converges fast.
  const Vector3d rigidity = 4 * t.stiffness * Vector3d{t.b * t.b, t.a * t.a, t.a * t.a + t.b * t.b};
  Eigen::Quaterniond R = Eigen::Quaterniond::Identity();
  for (int i = 0; i < 100; ++i) {
    Vector3d torque = (R * center).cross(weight);
    for (const Vector3d& c : places(t)) torque += t.stiffness * (R * c).cross(c);
    const Vector3d turn = torque.cwiseQuotient(rigidity);
    const double angle = turn.norm();
    if (angle == 0) break;
    R = (Eigen::Quaterniond(Eigen::AngleAxisd(angle, turn / angle)) * R).normalized();
    if (angle < 1e-17) break;
  }
  return R;
}

}  // namespace

std::array<double, 4> vertical_forces(const Tray& t) {
  const Eigen::Quaterniond R = lean(t);
  std::array<double, 4> force{};
  const auto c = places(t);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3d lowered = R * c[i];
    force[i] = t.mass * t.gravity / 4 - t.stiffness * lowered.z();
  }
  return force;
}

std::array<double, 4> level_forces(const Tray& t) {
  std::array<double, 4> force{};
  const auto c = places(t);
  for (std::size_t i = 0; i < 4; ++i)
    force[i] = t.mass * t.gravity * (0.25 + t.x * c[i].x() / (4 * t.a * t.a) + t.y * c[i].y() / (4 * t.b * t.b));
  return force;
}

Bounds rigid_bounds(const Tray& t) {
  // The null space is (+, −, −, +): the first may fall until it or the fourth is 0, and rise until the second or third
  // is.
  const auto N = level_forces(t);
  return {N[0] - std::min(N[0], N[3]), N[0] + std::min(N[1], N[2])};
}

}  // namespace handhold::closed_form
