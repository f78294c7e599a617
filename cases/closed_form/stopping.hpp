// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// C03. A block sliding at `speed` on a level palm stops by friction. L1 during the slide; what follows the stop is L2:
/// the springs, still loaded to their kinetic lag, push the block back, and it rings down to rest.
struct Stopping {
  double speed{0.8};  ///< v0 [m/s]
  double mu_dynamic{0.4};
  double gravity{9.81};  ///< [m/s²]
  double mass{0.2};      ///< [kg]
  double stiffness{};    ///< K, tangential, of all samples together [N/m]; 0: rigid (L1)
  double damping{};      ///< C of all samples together [N s/m], below critical
};

/// t = v0 / (μ_d g) [s].
[[nodiscard]] double stop_time(const Stopping& stopping);

/// D = v0² / (2 μ_d g) [m].
[[nodiscard]] double stop_distance(const Stopping& stopping);

/// Heat of the slide, ½ m v0² [J].
[[nodiscard]] double heat(const Stopping& stopping);

/// Distance slid at time t >= 0: v0 t − ½ μ_d g t² to the stop; after it D − ρ + ρ e^(−δτ) (cos ωτ + δ/ω sin ωτ) with
/// ρ = μ_d m g / K, δ = C / (2 m), ω² = K / m − δ², τ = t − t_stop.
[[nodiscard]] double distance(const Stopping& stopping, double t);

/// Where it comes to rest: D − μ_d m g / K (L2), D (L1) [m].
[[nodiscard]] double rest_distance(const Stopping& stopping);

}  // namespace handhold::closed_form
