// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/l3/families.hpp"

namespace handhold::catalogue {

std::vector<Case> printed_cases() {
  return {printed_sign_case(),        printed_slide_case(),      printed_chatter_case(),       printed_impulse_case(),
          printed_heavy_pinch_case(), printed_two_states_case(), printed_patch_case(),         printed_stability_case(),
          printed_centroid_case(),    printed_release_case(),    printed_slope_case(),         printed_cycle_case(),
          printed_ball_case(),        printed_spin_case(),       printed_light_squeeze_case(), printed_opening_case(),
          printed_drag_case(),        printed_overshoot_case()};
}

}  // namespace handhold::catalogue
