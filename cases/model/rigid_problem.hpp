// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "cases/model/body.hpp"
#include "cases/model/friction.hpp"
#include "cases/model/pose.hpp"
#include "cases/model/recording.hpp"
#include "cases/model/rigid_surface.hpp"

namespace handhold {

/// A prescribed translation and its two derivatives, in W.
struct PathPoint {
  Eigen::Vector3d p{Eigen::Vector3d::Zero()};  ///< [m]
  Eigen::Vector3d v{Eigen::Vector3d::Zero()};  ///< [m/s]
  Eigen::Vector3d a{Eigen::Vector3d::Zero()};  ///< [m/s²]
};

/// Twice continuously differentiable in t; validate() compares v and a with differences of p and v. Empty: at rest.
using RigidPath = std::function<PathPoint(double t)>;

[[nodiscard]] PathPoint at(const RigidPath& path, double t);

/// A prescribed attitude and its rates, in W.
struct TurnPoint {
  Eigen::Quaterniond R{Eigen::Quaterniond::Identity()};  ///< against how the surface is given; unit
  Eigen::Vector3d w{Eigen::Vector3d::Zero()};            ///< angular velocity [rad/s]
  Eigen::Vector3d alpha{Eigen::Vector3d::Zero()};        ///< its derivative [rad/s²]
};

/// As RigidPath; validate() compares w with differences of R, alpha with differences of w. Empty: does not turn.
using RigidTurn = std::function<TurnPoint(double t)>;

[[nodiscard]] TurnPoint at(const RigidTurn& turn, double t);

/// A hard contact of the body with a surface. The body touches with a point fixed in it (a foot: where it stands, not
/// where a finger wanders over its face) or with a ball fixed in it, which touches where the surface is nearest.
///
/// Unilateral (`normal_force` empty): the surface carries whatever keeps the body out, lets go when it would have to
/// pull, and meets it again with a plastic impact. Force-controlled: a finger or plate that follows the body along its
/// normal and presses with N(t); it is apart while N(t) <= 0. Both: stick (a ball rolls) as long as |f| <= μ_s N, else
/// slip with f = −μ_d N against the sliding velocity, in any tangential direction.
struct RigidSupport {
  RigidSurface surface{};                          ///< in a frame S of its own, which is W at path position 0
  RigidPath motion{};                              ///< p: place of S's origin
  RigidTurn turn{};                                ///< of S, about its origin: x_W = R x_S + p
  std::function<double(double t)> normal_force{};  ///< N(t) [N], continuous; planes only
  Friction friction{};
  Eigen::Vector3d point_B{Eigen::Vector3d::Zero()};  ///< the foot, or the centre of the ball [m]
  double radius{0};                                  ///< of the ball [m]; 0: a foot
};

/// The support's surface where it is at t: φ, ∇φ and ∇∇φ at the point x of W.
[[nodiscard]] Proximity proximity(const RigidSupport& support, double t, const Eigen::Vector3d& x_W);

/// A spring of no length from a point of the body to a moving point: force k (s(t) − p) on the body.
struct RigidSpring {
  double stiffness{};                                 ///< k [N/m]
  Eigen::Vector3d point_B{Eigen::Vector3d::Zero()};   ///< [m]
  Eigen::Vector3d anchor_W{Eigen::Vector3d::Zero()};  ///< at path position 0 [m]
  RigidPath motion{};                                 ///< translation of the anchor
};

/// Force at the centre of mass and torque as a function of time and of the body's motion.
using AppliedLoad = std::function<Load(double t, const BodyState& body)>;

/// One rigid body under rigid Coulomb friction: level L1 of docs/contact-law.md. B's origin is the centre of mass.
///
/// Honest for one contact, for contacts that are alike by symmetry (their share of the load is then equal: the solution
/// of least norm), and for contacts whose forces the motion determines. Where rigid bodies leave the share open, the
/// share is one of many.
struct RigidProblem {
  double mass{1};                                        ///< [kg]
  Eigen::Matrix3d inertia{Eigen::Matrix3d::Identity()};  ///< about the centre of mass, axes of B [kg m²]
  Mobility mobility{Mobility::free};                     ///< free or translation
  Pose X_WB{};                                           ///< at t = 0
  Twist V_WB{};                                          ///< at t = 0
  Eigen::Vector3d gravity{0, 0, -9.81};                  ///< [m/s²]
  std::vector<RigidSupport> supports{};                  ///< at most 5
  std::vector<RigidSpring> springs{};
  AppliedLoad load{};  ///< empty: none
  double duration{1};  ///< [s]
};

/// Throws InputError naming the first thing that cannot be simulated.
void validate(const RigidProblem& problem);

}  // namespace handhold
