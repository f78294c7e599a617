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

/// The reference integrates to 1e-10 a step, of its largest state, and locates events to 1e-9 s or better: ten times
/// that much of the truth is allowed where nothing magnifies it.
[[nodiscard]] Limit reference_limit();

/// The same where the truth hangs on a slow crossing or a small difference: `magnified` times as much, and why.
[[nodiscard]] Limit reference_limit(double magnified, const std::string& why);

/// Yes or no: nothing to tolerate.
[[nodiscard]] Limit exact_limit();

/// A change of mode shows at the end of the sub-step in which it happens; `substeps` above 1 need a reason.
[[nodiscard]] Limit event_limit(double substeps = 1, const std::string& why = "");

/// Bias of a semi-implicit Euler step after a phase of acceleration that changed the object's speed by `change`: ½
/// change h (catalogue case R03: exact), with 2 % for the onset's own step.
[[nodiscard]] Limit euler_bias_limit(double change);

}  // namespace handhold::catalogue
