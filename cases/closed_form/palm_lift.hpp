// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// D13. An object rests on a flat hand that moves up and down as y = A sin ωt. L1 for `stiffness` = 0: the object
/// follows the hand. L2 else: it stands on undamped springs K and starts in the forced oscillation without transient,
/// at depth g/Ω² and velocity A ω Ω²/(Ω² − ω²), with Ω² = K / m > ω²; the formulas tend to L1 as (ω/Ω)².
struct PalmLift {
  double amplitude{0.05};  ///< A [m]
  double frequency{18};    ///< ω [rad/s]
  double gravity{9.81};    ///< [m/s²]
  double mass{0.2};        ///< [kg], L2 only
  double stiffness{};      ///< K of all samples together [N/m]; 0: rigid
};

/// Whether the object ever leaves the hand: A ω² Ω²/(Ω² − ω²) > g.
[[nodiscard]] bool leaves(const PalmLift& lift);

/// sin(ω t1) = g/(A ω²) (1 − ω²/Ω²) [s]; NaN if it does not leave.
[[nodiscard]] double lift_off(const PalmLift& lift);

/// When the object, in free flight since lift-off, meets the hand again (root by bracketing, 1e-15 s) [s].
[[nodiscard]] double landing(const PalmLift& lift);

/// Velocity of the object relative to the hand at that moment, negative when closing [m/s].
[[nodiscard]] double landing_speed(const PalmLift& lift);

/// Height of the object above its place at t = 0, up to the landing [m].
[[nodiscard]] double height(const PalmLift& lift, double t);

/// Depth and upward velocity that the object must have at t = 0 [m], [m/s].
[[nodiscard]] double start_depth(const PalmLift& lift);
[[nodiscard]] double start_velocity(const PalmLift& lift);

}  // namespace handhold::closed_form
