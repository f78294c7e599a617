// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/case.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cases/catalogue/builders/variants.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/catalogue/l3/families.hpp"
#include "cases/model/defect.hpp"

namespace handhold::catalogue {

std::string_view to_string(Pedigree pedigree) {
  switch (pedigree) {
    case Pedigree::exact:
      return "exact";
    case Pedigree::discrete_exact:
      return "discrete-exact";
    case Pedigree::converged:
      return "converged";
    case Pedigree::published:
      return "published";
    case Pedigree::regression:
      return "regression";
  }
  return "?";
}

Limit controlled_limit() { return controlled_limit(1, ""); }

Limit controlled_limit(double magnified, const std::string& why) {
  return {.per_accuracy = DEFECT(controlled_limit_times_1e4, 10, 1e5) * magnified,
          .relative = true,
          .reason = "ten times the integrator's accuracy" + (why.empty() ? why : "; " + why)};
}

Limit absolute_controlled_limit(double magnified, const std::string& why) {
  return {.per_accuracy = 10 * magnified,
          .reason = "ten times the integrator's accuracy, which is absolute" + (why.empty() ? why : "; " + why)};
}

Limit exact_limit() { return {.value = 0, .reason = "yes or no: nothing to tolerate"}; }

Limit event_limit(double substeps, const std::string& why) {
  return {.per_step = substeps + DEFECT(event_limit_plus_5, 0.01, 5.01),
          .reason = "a change of mode shows at the end of its sub-step, + 1 % for rounding at its edge" +
                    (why.empty() ? why : "; " + why)};
}

Limit euler_bias_limit(double change) {
  return {
      .per_step = DEFECT(euler_limit_times_10, 0.51, 5.1) * std::abs(change),
      .reason = "semi-implicit Euler is off by half a sub-step times the change of speed (R03), + 2 % for the onset"};
}

Limit implicit_ring_limit(double amplitude, double frequency, double t) {
  const double damping = frequency * frequency * t / 2;
  return {.per_step = std::abs(amplitude) * damping * (1 + 2 * frequency / (3 * 360)),
          .reason =
              "the implicit step damps an oscillation by w^2 h/2 a second and slows it by (w h)^2/3: amplitude "
              "times w^2 t/2 (1 + 2 w h/3)"};
}

namespace {

std::vector<Case> compliant_cases() {
  return {projectile_case(),
          incline_case(),
          incline_flick_case(),
          stopping_case(),
          load_ramp_case(),
          harmonic_force_case(),
          friction_oscillator_case(),
          forced_oscillator_case(),
          belt_case(),
          oscillating_palm_case(),
          pinch_case(),
          pinch_opening_case(),
          catch_case(),
          shaken_pinch_case(),
          sideways_pinch_case(),
          palm_lift_case(),
          spin_down_case(),
          eccentric_load_case(),
          pivot_case(),
          sliding_spin_case(),
          drag_step_case(),
          sudden_release_case(),
          jenkins_loop_case(),
          moving_catch_case(),
          handover_case(),
          ratchet_case(),
          tray_case(),
          twist_case(),
          spin_stop_case(),
          held_cube_case(),
          normal_shake_case(),
          chatter_case(),
          unlike_blocks_case(),
          stack_case(),
          struck_case(),
          bounce_case(),
          pressed_case(),
          sweep_case(),
          round_cylinder_case(),
          round_sphere_case(),
          oblique_blow_case(),
          support_case()};
}

std::vector<Case> rigid_cases() {
  std::vector<Case> cases;
  for (const auto& family : {rigid_flights(), rigid_slides(), rigid_oscillators(), rigid_palms(), rigid_curves(),
                             rigid_pinches(), rigid_balls()})
    cases.insert(cases.end(), family.begin(), family.end());
  for (Case& c : cases) {
    c.level = Level::rigid;
    c.truth_level = "L1";
  }
  std::ranges::sort(cases, {}, &Case::id);
  return cases;
}

}  // namespace

/// The printed law has no other look: it sees voxels and rays, which a turned scene has elsewhere.
const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = [] {
    std::vector<Case> all = compliant_cases();
    for (Case& c : rigid_cases()) all.push_back(std::move(c));
    for (Case& c : all) c = with_variants(std::move(c));
    for (Case& c : DEFECT(printed_cases_dropped, printed_cases(), std::vector<Case>{})) all.push_back(std::move(c));
    return all;
  }();
  return cases;
}

}  // namespace handhold::catalogue
