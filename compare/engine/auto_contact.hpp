// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/hand/placement.hpp"
#include "cases/model/body.hpp"
#include "cases/model/contact_parameters.hpp"

namespace handhold::compare {

/// The contact element that suits a grip: stiffness by `realtime::auto_stiffness` (Höll et al. 2018, section 3.3) from
/// the object's mass, volume and friction and the grip's samples and depth, no deeper than the phalanges are as the
/// grip closes; damping so that the object on its springs has `auto_damping_ratio`.
///
/// The margin is 3, or 2 (1 + a / g) if the hand's load, |a - g| in units of g, asks for more.
[[nodiscard]] ContactParameters auto_contact(const Body& body, const Placement& placement, int samples_a_phalanx);

/// Of the object on the springs of the grip. With it, the default element (100 N/m, 0.5 N s/m, c/k = 5 ms) is what an
/// object of 75 g gets in a pinch: c/k is the same for every mass.
inline constexpr double auto_damping_ratio = 0.36;

}  // namespace handhold::compare
