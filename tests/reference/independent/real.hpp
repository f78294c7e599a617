// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

/// An event-driven solver of its own for the contact law of docs/contact-law.md, to certify the reference with.
///
/// It shares data with the reference (Scene, HandMotion, the numbers in the voxel field) and not one line of physics:
/// another integrator family, another arithmetic, other coordinates of body and anchors, its own spline, its own
/// location of events. Slow and small; used by tests only.
namespace handhold::independent {

using Real = long double;
using Vec3 = Eigen::Matrix<Real, 3, 1>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;
using Quat = Eigen::Quaternion<Real>;
using State = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

}  // namespace handhold::independent
