// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace handhold::closed_form {

/// A02. A free rigid body with two equal moments of inertia. Body axes coincide with W at t = 0.
struct SymmetricTop {
  double across{4e-4};   ///< I1 = I2 [kg m²]
  double along{1.5e-4};  ///< I3 [kg m²]
  double wobble{3};      ///< ω1 at t = 0; ω2 = 0 [rad/s]
  double spin{12};       ///< ω3 [rad/s]
};

/// Angular velocity in body axes: ω1 + iω2 turns at (I3 − I1)/I1 ω3 (Landau and Lifshitz, Mechanics, § 36) [rad/s].
[[nodiscard]] Eigen::Vector3d rates(const SymmetricTop& top, double t);

/// R_WB = Rot(L, |L| t/I1) Rot(e3, ω3 (1 − I3/I1) t), L = (I1 ω1, 0, I3 ω3) (§ 33).
[[nodiscard]] Eigen::Matrix3d attitude(const SymmetricTop& top, double t);

/// A03. A free rigid body with I1 < I2 < I3; near the intermediate axis it flips over and over (the tennis racket).
/// Body axes coincide with W at t = 0.
struct AsymmetricTop {
  Eigen::Vector3d moments{1e-4, 2e-4, 2.6e-4};  ///< I1 < I2 < I3 [kg m²]
  double w1{2}, w3{6};                          ///< at t = 0, both > 0; ω2 = 0 [rad/s]
};

/// Angular velocity in body axes (Landau and Lifshitz, Mechanics, § 37) [rad/s]: for L² > 2 E I2
///   ω1 = A1 cn τ, ω2 = A2 sn τ, ω3 = A3 dn τ, τ = p t, p² = (I3 − I2)(L² − 2 E I1)/(I1 I2 I3),
///   k² = (I2 − I1)(2 E I3 − L²)/((I3 − I2)(L² − 2 E I1));
/// else axes 1 and 3 change places. At the separatrix L² = 2 E I2 the period is infinite.
[[nodiscard]] Eigen::Vector3d rates(const AsymmetricTop& top, double t);

/// 4 K(k) / p [s].
[[nodiscard]] double period(const AsymmetricTop& top);

/// R_WB: Euler's angles about L, of which the precession is the quadrature of
/// φ' = L (I1 ω1² + I2 ω2²)/(I1² ω1² + I2² ω2²).
[[nodiscard]] Eigen::Matrix3d attitude(const AsymmetricTop& top, double t);

}  // namespace handhold::closed_form
