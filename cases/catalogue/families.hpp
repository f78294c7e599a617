#pragma once

#include "cases/catalogue/case.hpp"

namespace handhold::catalogue {

// One function a case; ids as in the catalogue (docs/cases.md).

[[nodiscard]] Case incline_case();        // C01
[[nodiscard]] Case stopping_case();       // C03
[[nodiscard]] Case pinch_case();          // D01
[[nodiscard]] Case pinch_opening_case();  // D02
[[nodiscard]] Case palm_lift_case();      // D13
[[nodiscard]] Case spin_down_case();      // F01

// Limits shared by the cases.

/// The reference is error controlled at 1e-10 or tighter: what remains is far below 1e-7 of the truth.
[[nodiscard]] Limit reference_limit();

/// Yes or no: nothing to tolerate.
[[nodiscard]] Limit exact_limit();

/// A change of mode shows at the end of the frame in which it happens.
[[nodiscard]] Limit one_frame_limit();

/// Bias of a semi-implicit Euler step after a phase of acceleration that changed the speed by `change`: ½ change h
/// (catalogue case R03: exact), with 2 % for the onset's own step.
[[nodiscard]] Limit euler_bias_limit(double change);

}  // namespace handhold::catalogue
