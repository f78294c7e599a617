// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "cases/model/friction.hpp"
#include "cases/model/recording.hpp"
#include "realtime/paper/options.hpp"

namespace handhold::realtime::paper {

/// One contact sample at one instant; all vectors in one frame.
struct Sample {
  Eigen::Vector3d C{Eigen::Vector3d::Zero()};    ///< anchor on the object's surface [m]
  Eigen::Vector3d n{Eigen::Vector3d::UnitZ()};   ///< outward normal there, unit
  Eigen::Vector3d p{Eigen::Vector3d::Zero()};    ///< point of the phalanx [m]
  Eigen::Vector3d v_C{Eigen::Vector3d::Zero()};  ///< velocities of the two, for a damper [m/s]
  Eigen::Vector3d v_p{Eigen::Vector3d::Zero()};
};

/// The spring's force as eq. 1 prints it, γ (C − p), with the damper's c (v_C − v_p) beside it, and its parts.
struct PrintedForce {
  Eigen::Vector3d f{Eigen::Vector3d::Zero()};        ///< eq. 1 [N]
  double normal{};                                   ///< eq. 2: f·n
  Eigen::Vector3d tangent{Eigen::Vector3d::Zero()};  ///< eq. 3: f − (f·n) n
  bool pushes{};                                     ///< p below the surface and f·n > 0
};

[[nodiscard]] PrintedForce printed_force(const Sample& sample, const Options& options);

/// Eq. 4: stick inside the cone (edge included), slip outside; apart where the gate holds it back. `slipping`: it
/// slipped in the last frame.
[[nodiscard]] Mode classify(const PrintedForce& force, bool slipping, const Friction& friction, const Options& options);

/// Eq. 5 with its sign: what the object is given at C, in a mode found before [N].
[[nodiscard]] Eigen::Vector3d force_on_object(const PrintedForce& force, const Eigen::Vector3d& n, Mode mode,
                                              const Friction& friction, const Options& options);

/// Derivatives of force_on_object in a mode that stays: by the pull a = −f, and by the normal (which turns with the
/// body).
struct ForceSlopes {
  Eigen::Matrix3d by_pull{Eigen::Matrix3d::Zero()};
  Eigen::Matrix3d by_normal{Eigen::Matrix3d::Zero()};
};

[[nodiscard]] ForceSlopes force_slopes(const PrintedForce& force, const Eigen::Vector3d& n, Mode mode,
                                       const Friction& friction, const Options& options);

}  // namespace handhold::realtime::paper
