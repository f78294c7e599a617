// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// G09. An object spins about the axis of a pinch of two opposite rings whose springs are slack at t = 0. L2, exact at
/// finite angles, no gravity: while all samples stick the object is a pendulum with Ω² = 2 K a² / I; they slip together
/// at a chord of μ_s N / K, along curves of pursuit (pursuit.hpp); after the stop it is a pendulum again.
struct SpinStop {
  double inertia{1e-4};    ///< I about the axis [kg m²]
  double normal_force{2};  ///< N of each ring [N]
  double radius{0.004};    ///< a [m]
  double stiffness{8000};  ///< K of each ring [N/m]
  double spin{5};          ///< ω0 > 0 [rad/s]
  Friction friction{};
};

/// Ω [rad/s]
[[nodiscard]] double torsional_frequency(const SpinStop& stop);

/// Spin up to which nothing slips: a ω / Ω = μ_s N / K [rad/s].
[[nodiscard]] double critical_spin(const SpinStop& stop);

/// Angle and spin at the breakaway serve the stop, which G09 asks for. Of the following, all but the angles at sticking
/// presume ω0 > critical_spin.
[[nodiscard]] double breakaway_angle(const SpinStop& stop);  ///< 2 asin(μ_s N / (2 K a)) [rad]
[[nodiscard]] double breakaway_time(const SpinStop& stop);   ///< [s]
[[nodiscard]] double breakaway_spin(const SpinStop& stop);   ///< √(ω0² − 4 Ω² sin²(θ1/2)) [rad/s]
[[nodiscard]] double restick_angle(const SpinStop& stop);    ///< where the friction has taken all energy [rad]
[[nodiscard]] double restick_time(const SpinStop& stop);  ///< t1 + ∫ I dω / (T cos ψ(ω)), by quadrature to 1e-13 [s]

/// Amplitude of the oscillation that is left: the angle from the anchors to the samples at the stop [rad].
[[nodiscard]] double residual_amplitude(const SpinStop& stop);

/// Angle turned at t: while nothing has slipped, or after the stop; NaN between [rad].
[[nodiscard]] double angle(const SpinStop& stop, double t);

/// Frequency of that oscillation for small angles: √(2 K a b / I), b the radius that the anchors came to [rad/s].
[[nodiscard]] double residual_frequency(const SpinStop& stop);

}  // namespace handhold::closed_form
