// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/catalogue/case.hpp"

namespace handhold::catalogue {

// Level L3, one function a case; each file of this folder holds a family.

[[nodiscard]] Case printed_sign_case();           // L3-01
[[nodiscard]] Case printed_slide_case();          // L3-02
[[nodiscard]] Case printed_chatter_case();        // L3-03
[[nodiscard]] Case printed_impulse_case();        // L3-04
[[nodiscard]] Case printed_heavy_pinch_case();    // L3-05
[[nodiscard]] Case printed_two_states_case();     // L3-06
[[nodiscard]] Case printed_patch_case();          // L3-07
[[nodiscard]] Case printed_stability_case();      // L3-08
[[nodiscard]] Case printed_centroid_case();       // L3-09
[[nodiscard]] Case printed_release_case();        // L3-10
[[nodiscard]] Case printed_slope_case();          // L3-11
[[nodiscard]] Case printed_cycle_case();          // L3-12
[[nodiscard]] Case printed_ball_case();           // L3-13
[[nodiscard]] Case printed_spin_case();           // L3-14
[[nodiscard]] Case printed_light_squeeze_case();  // L3-15
[[nodiscard]] Case printed_opening_case();        // L3-16
[[nodiscard]] Case printed_drag_case();           // L3-17
[[nodiscard]] Case printed_overshoot_case();      // L3-18

/// All of them, ascending in id.
[[nodiscard]] std::vector<Case> printed_cases();

}  // namespace handhold::catalogue
