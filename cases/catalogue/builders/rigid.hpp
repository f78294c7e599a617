// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <Eigen/Core>

#include "cases/model/rigid_problem.hpp"

// Rigid problems (L1) that cases, tests and benchmarks share.

namespace handhold::catalogue::rigid {

inline constexpr double g = 9.81;  ///< [m/s²]
inline const Eigen::Vector3d x_axis = Eigen::Vector3d::UnitX(), y_axis = Eigen::Vector3d::UnitY(),
                             z_axis = Eigen::Vector3d::UnitZ();

/// A block that does not turn, with its foot at the origin on the plane z = 0.
[[nodiscard]] RigidProblem block(double mass, const Friction& friction, double duration);

/// The block tied by a spring to the origin, x from it.
[[nodiscard]] RigidProblem sprung_block(double mass, double stiffness, const Friction& friction, double x,
                                        double duration);

/// Fingers evenly around the z axis that press inwards with N(t) each, on feet of a body that does not turn; two of
/// them face each other along y. `hand` is their common motion.
[[nodiscard]] RigidProblem grip(int fingers, double mass, const Friction& friction,
                                const std::function<double(double)>& N, const RigidPath& hand, double duration);

/// A ball of inertia β m r² that touches the plane z = 0.
[[nodiscard]] RigidProblem ball(double mass, double radius, double beta, double mu, double duration);

/// A ball without weight at the origin, between the plate z = −r (support 0) and one that presses from above with N.
[[nodiscard]] RigidProblem ball_between_plates(double mass, double radius, double beta, double N, double mu,
                                               const RigidPath& upper, const RigidPath& lower, double duration);

/// Gravity as seen from a slope that falls towards +x.
[[nodiscard]] Eigen::Vector3d tilted_gravity(double slope, double gravity = g);

[[nodiscard]] std::function<double(double)> constant(double value);

/// `amplitude` sin(frequency t + phase) along an axis.
[[nodiscard]] RigidPath sine(const Eigen::Vector3d& axis, double amplitude, double frequency, double phase = 0);

/// v t, a t²/2, j t³/6.
[[nodiscard]] RigidPath steady(const Eigen::Vector3d& velocity);
[[nodiscard]] RigidPath accelerating(const Eigen::Vector3d& acceleration);
[[nodiscard]] RigidPath jerking(const Eigen::Vector3d& jerk);

/// About a unit axis: angle rate t + acceleration t²/2.
[[nodiscard]] RigidTurn turning(const Eigen::Vector3d& axis, double rate, double acceleration = 0);

}  // namespace handhold::catalogue::rigid
