// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// G11, G06. Two opposite fingers hold an object and shake along their normals, y = A sin ωt. L2: the object lags, and
/// z = object − hand obeys z'' + (2K/m) z = A ω² sin ωt; started in the forced oscillation it has no transient. The
/// sum of the normal forces stays 2 K d0; L1 has no relative motion.
struct ShakenPinch {
  double mass{0.2};         ///< [kg]
  double stiffness{800};    ///< K of each finger, normal [N/m]
  double preload{0.003};    ///< d0 [m]
  double amplitude{0.004};  ///< A [m]
  double frequency{40};     ///< ω [rad/s], below √(2K/m)
};

/// Z = A ω² / (2K/m − ω²) [m].
[[nodiscard]] double relative_amplitude(const ShakenPinch& pinch);

/// z(t) = Z sin ωt [m].
[[nodiscard]] double relative_displacement(const ShakenPinch& pinch, double t);

/// Normal force of the finger towards which z is counted, K (d0 + z); the other has K (d0 − z) [N]. G11 asks for z, of
/// which it is a linear function.
[[nodiscard]] double normal_force(const ShakenPinch& pinch, double t);

/// A at which a finger lets go, Z = d0 [m].
[[nodiscard]] double critical_amplitude(const ShakenPinch& pinch);

/// Velocity of the object at t = 0, (A + Z) ω [m/s].
[[nodiscard]] double start_velocity(const ShakenPinch& pinch);

}  // namespace handhold::closed_form
