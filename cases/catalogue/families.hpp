// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/catalogue/case.hpp"

namespace handhold::catalogue {

// One function a case; ids as in the catalogue (docs/cases.md).

[[nodiscard]] Case projectile_case();           // A01
[[nodiscard]] Case incline_case();              // C01
[[nodiscard]] Case incline_flick_case();        // C02
[[nodiscard]] Case stopping_case();             // C03
[[nodiscard]] Case load_ramp_case();            // C04
[[nodiscard]] Case harmonic_force_case();       // C05
[[nodiscard]] Case friction_oscillator_case();  // C06
[[nodiscard]] Case forced_oscillator_case();    // C07
[[nodiscard]] Case belt_case();                 // C08
[[nodiscard]] Case oscillating_palm_case();     // C09
[[nodiscard]] Case pinch_case();                // D01
[[nodiscard]] Case pinch_opening_case();        // D02
[[nodiscard]] Case catch_case();                // D03
[[nodiscard]] Case shaken_pinch_case();         // D04
[[nodiscard]] Case sideways_pinch_case();       // D06
[[nodiscard]] Case palm_lift_case();            // D13
[[nodiscard]] Case spin_down_case();            // F01
[[nodiscard]] Case eccentric_load_case();       // F02
[[nodiscard]] Case pivot_case();                // F03
[[nodiscard]] Case sliding_spin_case();         // F04
[[nodiscard]] Case drag_step_case();            // G01
[[nodiscard]] Case sudden_release_case();       // G02
[[nodiscard]] Case jenkins_loop_case();         // G03
[[nodiscard]] Case moving_catch_case();         // G04
[[nodiscard]] Case handover_case();             // G05
[[nodiscard]] Case ratchet_case();              // G06
[[nodiscard]] Case tray_case();                 // G07
[[nodiscard]] Case twist_case();                // G08
[[nodiscard]] Case spin_stop_case();            // G09
[[nodiscard]] Case held_cube_case();            // G10
[[nodiscard]] Case normal_shake_case();         // G11
[[nodiscard]] Case chatter_case();              // G12
[[nodiscard]] Case unlike_blocks_case();        // H01
[[nodiscard]] Case stack_case();                // H02
[[nodiscard]] Case struck_case();               // H03
[[nodiscard]] Case bounce_case();               // H04
[[nodiscard]] Case pressed_case();              // H05
[[nodiscard]] Case sweep_case();                // H06
[[nodiscard]] Case round_cylinder_case();       // H07
[[nodiscard]] Case round_sphere_case();         // H08
[[nodiscard]] Case oblique_blow_case();         // H09
[[nodiscard]] Case support_case();              // H10

// A finger at edges and corners: X01 to X09.
[[nodiscard]] std::vector<Case> edge_cases();

// One function a family of rigid cases (L1); their problems: builders/rigid.hpp.

[[nodiscard]] std::vector<Case> rigid_flights();      // A01 to A03, B02
[[nodiscard]] std::vector<Case> rigid_slides();       // C01 to C04, C20
[[nodiscard]] std::vector<Case> rigid_oscillators();  // C05 to C09
[[nodiscard]] std::vector<Case> rigid_palms();        // C11, C12, D13
[[nodiscard]] std::vector<Case> rigid_curves();       // C14 to C16
[[nodiscard]] std::vector<Case> rigid_pinches();      // D01 to D04, D06
[[nodiscard]] std::vector<Case> rigid_balls();        // E01 to E07

// Limits shared by the cases.

/// A method that controls its error does so a step, for its largest state, and locates events to ten times its accuracy
/// or better: ten times the accuracy of the truth is allowed where nothing magnifies it.
[[nodiscard]] Limit controlled_limit();

/// The same where the truth hangs on a slow crossing or a small difference: `magnified` times as much, and why.
[[nodiscard]] Limit controlled_limit(double magnified, const std::string& why);

/// Yes or no: nothing to tolerate.
[[nodiscard]] Limit exact_limit();

/// A change of mode shows at the end of the sub-step in which it happens; `substeps` above 1 need a reason.
[[nodiscard]] Limit event_limit(double substeps = 1, const std::string& why = "");

/// Bias of a semi-implicit Euler step after a phase of acceleration that changed the object's speed by `change`: ½
/// change h (catalogue case R03: exact), with 2 % for the onset's own step.
[[nodiscard]] Limit euler_bias_limit(double change);

/// The integrator's accuracy is absolute: ten times 1e-10 [m, rad, m/s, ...], for quantities that are small or may
/// vanish; `magnified` times as much, and why.
[[nodiscard]] Limit absolute_controlled_limit(double magnified = 1, const std::string& why = "");

/// An undamped oscillation of `amplitude` and `frequency`, t after it began: a fully implicit step (1 + iωh)^(−1) damps
/// it by ω² h/2 a second and slows it by (ωh)²/3, the latter taken at the sub-step 1/360 s.
[[nodiscard]] Limit implicit_ring_limit(double amplitude, double frequency, double t);

}  // namespace handhold::catalogue
