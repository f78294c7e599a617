// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "reference/rigid/contact_point.hpp"

namespace handhold::reference::rigid {

/// Velocity of the contact point per impulse there: K = 1/m + [arm]ᵀ J⁻¹ [arm] (the first term alone for a body that
/// only translates) [1/kg].
[[nodiscard]] Eigen::Matrix3d response(const RigidProblem& problem, const Motion& body, const Eigen::Vector3d& arm);

/// Adds an impulse at the end of `arm` [N s].
void strike(const RigidProblem& problem, const Eigen::Vector3d& arm, const Eigen::Vector3d& impulse, Motion& body);

/// The impulse of a plastic impact (Newton's restitution 0) under Coulomb friction: it stops the contact point if it
/// lies in the cone, else it is N(n − μ_d d) with d the direction of sliding. Nothing, if sliding would then turn or
/// reverse: Routh's method would be needed, which is not built.
[[nodiscard]] std::optional<Eigen::Vector3d> plastic_impulse(const RigidProblem& problem, const RigidSupport& support,
                                                             const ContactPoint& point, const Motion& body);

/// Takes from the body the velocity that contacts with these wishes forbid, by impulses at the contact points in turn
/// until nothing changes: the noise left at an event, not a finite jump.
struct Rest {
  ContactPoint point{};
  bool normal{false};      ///< no velocity along the normal
  bool tangential{false};  ///< nor across it
};

void bring_to_rest(const RigidProblem& problem, const std::vector<Rest>& contacts, Motion& body);

}  // namespace handhold::reference::rigid
