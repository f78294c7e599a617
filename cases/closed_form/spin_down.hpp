// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// How the normal force of a patch is spread.
enum class PatchShape {
  ring,   ///< on a circle of radius a; any n >= 2 equally spaced samples give the same torque
  disc,   ///< evenly over a disc of radius a
  hertz,  ///< as Hertz' pressure over a disc of radius a
};

/// F01. An object spins about the axis of a pinch of two opposite patches and is stopped by their torsional friction.
/// No gravity. L1 for `stiffness` = 0. L2 (ring only): every anchor trails its sample by the lag ρ = μ N / K on a
/// pursuit curve, a circle of radius √(a² − ρ²), to which the force is tangent; so the torque is that of a ring of this
/// radius.
struct SpinDown {
  double inertia{1e-4};    ///< about the axis [kg m²]
  double normal_force{2};  ///< N of each patch [N]
  double mu{0.5};          ///< μ_d
  double radius{0.004};    ///< a [m]
  double spin{20};         ///< ω0 [rad/s]
  double stiffness{};      ///< K, tangential, of one patch [N/m]; 0: rigid
};

/// Lag of an anchor behind its sample while it slips: ρ = μ N / K [m].
[[nodiscard]] double lag(const SpinDown& spin);

/// T = 2 μ N a times 1 (ring), 2/3 (disc), 3π/16 (Hertz) [N m].
[[nodiscard]] double torque(const SpinDown& spin, PatchShape shape);

/// t = I ω0 / T [s].
[[nodiscard]] double stop_time(const SpinDown& spin, PatchShape shape);

/// I ω0² / (2 T) [rad].
[[nodiscard]] double stop_angle(const SpinDown& spin, PatchShape shape);

/// Angle turned at time t, up to the stop [rad].
[[nodiscard]] double angle(const SpinDown& spin, PatchShape shape, double t);

}  // namespace handhold::closed_form
