// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

namespace handhold {

/// One phalanx that presses on the object. Vectors in W.
struct GripPad {
  Eigen::Vector3d p{Eigen::Vector3d::Zero()};   ///< [m]
  Eigen::Vector3d n{Eigen::Vector3d::UnitZ()};  ///< unit, outward normal of the object
  double depth{};                               ///< of the skin before the object gives way [m], > 0
  double ring{0.003};                           ///< radius of its ring of samples [m]
};

/// What the grip has to carry, and what it is made of.
struct GripLoad {
  Eigen::Vector3d force{Eigen::Vector3d::Zero()};   ///< on the object at its centre of mass: weight less m a [N]
  Eigen::Vector3d center{Eigen::Vector3d::Zero()};  ///< of mass [m]
  double stiffness{};                               ///< of a pad: its number of samples times k [N/m], > 0
  double mu{};                                      ///< static
};

/// Friction that the pads' pressure allows over the friction that holding the load takes: >= 1 carries, 0 does not
/// press at all.
///
/// The object rests on the pads' springs, all of them sticking: six equations of equilibrium for its small motion
/// (docs/contact-law.md, the element at rest), with each pad's ring resisting turns by K r²/2 (1 + n nᵀ). Slip that
/// redistributes the load is left out, so the margin is a rank, not a bound: the engines have the last word.
[[nodiscard]] double grip_margin(const std::vector<GripPad>& pads, const GripLoad& load);

}  // namespace handhold
