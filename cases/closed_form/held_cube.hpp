// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// G10. A cube between two opposite sample rings, centred on its faces, all samples sticking. L2: the springs pull from
/// points of the body to points in space with zero natural length, so a displacement is harmonic at any amplitude and a
/// turn about an axis through the centre is a pendulum, θ'' = −Ω² sin θ, at any angle. No gravity but for `sag`.
struct HeldCube {
  double mass{0.2};       ///< [kg]
  double edge{0.05};      ///< s [m]
  double stiffness{800};  ///< K of each ring, normal and tangential [N/m]
  double radius{0.004};   ///< a [m]
  double depth{0.0025};   ///< d = N / K [m]
  double gravity{9.81};   ///< [m/s²]
};

/// About any axis through the centre: m s² / 6 [kg m²]; serves the frequencies below.
[[nodiscard]] double inertia(const HeldCube& cube);

/// √(2 K / m), along the normal as across it [rad/s].
[[nodiscard]] double translation_frequency(const HeldCube& cube);

/// About a tangential axis: Ω² = (2 K s²/4 + 2 K a²/2 − N s) / I. The last term is the preload's: the springs push from
/// inside the faces [rad/s].
[[nodiscard]] double roll_frequency(const HeldCube& cube);

/// About the axis of the pinch: Ω² = 2 K a² / I [rad/s].
[[nodiscard]] double spin_frequency(const HeldCube& cube);

/// m g / (2 K) [m].
[[nodiscard]] double sag(const HeldCube& cube);

}  // namespace handhold::closed_form
