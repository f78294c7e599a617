// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "cases/model/recording.hpp"
#include "reference/rigid/contact_point.hpp"

namespace handhold::reference::rigid {

/// What a support does in a phase. A ball that sticks rolls.
struct Contact {
  Mode mode{Mode::apart};
  /// Slip: the direction of sliding when the phase's last step began [unit]. It tells which way is forward, so that a
  /// trial step that runs past a stop keeps its friction instead of flipping it: the stop is then the regular zero of
  /// u · held.
  Eigen::Vector3d held{Eigen::Vector3d::Zero()};
};

using Modes = std::vector<Contact>;

/// Unit direction of sliding: ±u/|u|, forward with respect to `held`; below `slow` [m/s], `held` itself, made
/// tangential.
///
/// Near rest, friction along u/|u| damps sideways motion at the rate μN/(m|u|), which no explicit integrator can
/// follow, and the direction is noise in the end. Holding it there errs sideways by less than slow times the angle
/// turned through meanwhile, and the error dies at that same rate.
[[nodiscard]] Eigen::Vector3d slip_direction(const Contact& contact, const ContactPoint& point, double slow);

/// What a support does under trial modes, at given place and velocity.
struct Reaction {
  ContactPoint point{};
  ContactRates rates{};
  double normal_force{};                              ///< N [N]; negative: it would have to pull
  Eigen::Vector3d friction{Eigen::Vector3d::Zero()};  ///< on the body [N]
};

/// μ_s N − |f| [N]: negative outside the cone.
[[nodiscard]] double cone_margin(const RigidSupport& support, const Reaction& reaction);

}  // namespace handhold::reference::rigid
