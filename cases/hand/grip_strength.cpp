// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/grip_strength.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace handhold {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

Eigen::Matrix3d cross(const Eigen::Vector3d& r) {
  return (Eigen::Matrix3d() << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0).finished();
}

/// Of a pad's ring against a turn of the object [N m/rad].
Eigen::Matrix3d turn_stiffness(const GripPad& pad, double stiffness) {
  return stiffness * pad.ring * pad.ring / 2 * (Eigen::Matrix3d::Identity() + pad.n * pad.n.transpose());
}

/// Small motion (u, turn) of the object about its centre of mass at which the springs carry the load.
Vector6 settle(const std::vector<GripPad>& pads, const GripLoad& load) {
  Matrix6 K = Matrix6::Zero();
  Vector6 w = Vector6::Zero();
  w.head<3>() = load.force;
  for (const GripPad& pad : pads) {
    const Eigen::Matrix3d R = cross(pad.p - load.center);
    K.topLeftCorner<3, 3>() += load.stiffness * Eigen::Matrix3d::Identity();
    K.topRightCorner<3, 3>() -= load.stiffness * R;
    K.bottomLeftCorner<3, 3>() += load.stiffness * R;
    K.bottomRightCorner<3, 3>() += turn_stiffness(pad, load.stiffness) - load.stiffness * R * R;
    const Eigen::Vector3d pressure = -load.stiffness * pad.depth * pad.n;
    w.head<3>() += pressure;
    w.tail<3>() += R * pressure;
  }
  return K.ldlt().solve(w);
}

}  // namespace

double grip_margin(const std::vector<GripPad>& pads, const GripLoad& load) {
  if (pads.empty()) return 0;
  const Vector6 motion = settle(pads, load);
  if (!motion.allFinite()) return 0;
  const Eigen::Vector3d u = motion.head<3>(), turn = motion.tail<3>();
  double allowed = 0, needed = 0;
  for (const GripPad& pad : pads) {
    const Eigen::Vector3d moved = u + turn.cross(pad.p - load.center);  // of the object at the pad
    const double pressed = pad.depth + moved.dot(pad.n);
    if (pressed <= 0) continue;                                        // it has let go
    const double twist = load.stiffness * pad.ring * turn.dot(pad.n);  // torque about n over the ring's radius
    const double across = load.stiffness * (moved - moved.dot(pad.n) * pad.n).norm();
    allowed += load.mu * load.stiffness * pressed;
    needed += std::hypot(across, twist);
  }
  return needed > 0 ? allowed / needed : 0;
}

}  // namespace handhold
