// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/model/friction.hpp"
#include "cases/model/pose.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold {

/// Which of a body's six degrees of freedom exist.
enum class Mobility { free, translation, fixed };

/// Mass properties about the centre of mass, in the body's (object's) frame O.
struct Inertia {
  double mass{};                                          ///< [kg], > 0
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};        ///< centre of mass in O [m]
  Eigen::Matrix3d about_center{Eigen::Matrix3d::Zero()};  ///< [kg m²], axes of O
};

/// The support that holds a body up until `Body::held_until`: it carries the body's weight and resists its motion like
/// thick oil, with force −m v / τ at the centre of mass and torque −I ω / τ. So a hand that closes moves the body to
/// where its fingers are in balance; a rigid support would let it go under whatever force the fingers happen to leave
/// over. τ [s]:
inline constexpr double support_time = 0.01;

/// A force at a body's centre of mass and a torque, both in W.
struct Load {
  Eigen::Vector3d force_W{Eigen::Vector3d::Zero()};   ///< [N]
  Eigen::Vector3d torque_W{Eigen::Vector3d::Zero()};  ///< [N m]
};

/// One object, ready to simulate.
struct Body {
  std::string name{};
  std::shared_ptr<const VoxelField> field{};
  Inertia inertia{};
  Mobility mobility{Mobility::free};
  Friction friction{};   ///< against skin; two bodies have `combined` of theirs
  Pose X_WO{};           ///< at t = 0
  Twist V_WO{};          ///< at t = 0; v is the velocity of O's origin
  double held_until{0};  ///< a support (see support_time) holds the body up until then [s]
  /// Points of the body's surface, in O, that touch the surfaces of the other bodies, at most 255; none: it is touched
  /// by others' samples only. See surface_samples (geometry/surface_samples.hpp).
  std::vector<Eigen::Vector3d> samples_O{};
  std::function<Load(double t)> load{};  ///< applied besides gravity, smooth in t; empty: none
};

/// Throws InputError, its sentence beginning with `who` ("body 'cube'"), for what cannot be simulated: no shape, NaN,
/// mass <= 0, an inertia that no solid can have, mu_d > mu_s, a velocity that the mobility forbids.
void validate(const Body& body, const std::string& who);

}  // namespace handhold
