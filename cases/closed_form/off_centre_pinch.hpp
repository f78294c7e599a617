// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// S5. An object held off-centre between two fingertips and let go: a pendulum about the axis of the pinch, with a
/// constant torque of friction. L1: I φ'' = −m g l sin φ − T sign(φ'), φ from hanging.
struct OffCentrePinch {
  double mass{0.2};                                       ///< m [kg]
  double arm{0.02};                                       ///< l, from the pivot to the centre of mass [m]
  double inertia{0.2 * (0.06 * 0.06 / 6 + 0.02 * 0.02)};  ///< I about the pivot [kg m²]
  double gravity{9.81};                                   ///< [m/s²]
  double torque{};                                        ///< T >= 0 of both fingertips [N m]
};

/// Half a period of the swing between ±`start` [rad] without friction: 2 K(sin(start/2)) √(I / (m g l)) [s].
[[nodiscard]] double half_period(const OffCentrePinch& pinch, double start);

/// The angle at which a swing from rest at `start` > 0 first comes to rest [rad], <= start:
/// m g l (cos φ − cos start) = T (start − φ). `start` itself if friction holds it, −start if there is none.
[[nodiscard]] double turning_angle(const OffCentrePinch& pinch, double start);

}  // namespace handhold::closed_form
