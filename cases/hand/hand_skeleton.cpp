// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/hand_skeleton.hpp"

#include <cmath>

namespace handhold {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

// Of the palm's half length, so that their mean is 1; after the middle metacarpal the hand falls off to the little
// finger.
constexpr std::array<double, 4> knuckle_height{1.02, 1.08, 1.01, 0.89};

Vector3d mirrored(const Vector3d& v, Side side) { return side == Side::right ? v : Vector3d(-v.x(), v.y(), v.z()); }

Quaterniond thumb_axes(Side side) {
  const Vector3d z = mirrored(Vector3d(0.6, -0.3, 0.742).normalized(), side);
  const Vector3d dorsal = mirrored(Vector3d(1, 1, 0).normalized(), side);
  const Vector3d y = (dorsal - dorsal.dot(z) * z).normalized();
  Eigen::Matrix3d R;
  R << y.cross(z), y, z;
  return Quaterniond(R).normalized();
}

Pose turn(double angle, const Vector3d& axis) { return {Quaterniond(AngleAxisd(angle, axis)), Vector3d::Zero()}; }

Pose forward(double length) { return {Quaterniond::Identity(), {0, 0, length}}; }

}  // namespace

FingerBases finger_bases(const HandModel& model, Side side) {
  const Vector3d& half = model.palm_box.half_extents;
  FingerBases bases;
  bases[0] = {thumb_axes(side), mirrored({0.55 * half.x(), -0.5 * half.y(), -0.6 * half.z()}, side)};
  const double index = half.x() - model.capsules[3].radius;
  const double little = -(half.x() - model.capsules[12].radius);
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = index + (little - index) * static_cast<double>(i) / 3;
    bases[i + 1] = {Quaterniond::Identity(), mirrored({x, 0, knuckle_height[i] * half.z()}, side)};
  }
  return bases;
}

Vector3d hinge_axis(int finger, Side side) {
  return finger == 0 ? Vector3d(thumb_axes(side) * Vector3d::UnitX()) : Vector3d(Vector3d::UnitX());
}

FingerPose curled(int finger, double curl) {
  constexpr double degree = 3.14159265358979323846 / 180;
  if (finger == 0) return {{curl * 25 * degree, curl * 45 * degree, curl * 60 * degree}, 0};
  return {{curl * 75 * degree, curl * 100 * degree, curl * 65 * degree}, 0};
}

std::array<Pose, phalanx_count> forward_kinematics(const HandModel& model, Side side, const Pose& X_WPalm,
                                                   const std::array<FingerPose, 5>& fingers) {
  const FingerBases bases = finger_bases(model, side);
  const double towards_thumb = side == Side::right ? 1 : -1;
  std::array<Pose, phalanx_count> X_WP;
  X_WP[palm] = X_WPalm;
  for (std::size_t finger = 0; finger < 5; ++finger) {
    Pose X_WJ = X_WPalm * bases[finger] * turn(towards_thumb * fingers[finger].spread, Vector3d::UnitY());
    for (std::size_t bone = 0; bone < 3; ++bone) {
      const std::size_t i = 3 * finger + bone;
      const double half = model.capsules[i].half_length;
      X_WJ = X_WJ * turn(fingers[finger].flexion[bone], Vector3d::UnitX());
      X_WP[i] = X_WJ * forward(half);
      X_WP[i].R.normalize();
      X_WJ = X_WJ * forward(2 * half);
    }
  }
  return X_WP;
}

}  // namespace handhold
