// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// C02. A block is flicked up a slope at v0, stops, and stays or returns. L1.
struct Flick {
  double slope{0.6};     ///< θ [rad]
  double speed{1};       ///< v0 [m/s]
  double gravity{9.81};  ///< [m/s²]
  Friction friction{};
};

/// v0 / (g (sin θ + μ_d cos θ)) [s]; v0² / (2 g (sin θ + μ_d cos θ)) [m].
[[nodiscard]] double stop_time(const Flick& f);
[[nodiscard]] double stop_distance(const Flick& f);

/// tan θ > μ_s.
[[nodiscard]] bool returns(const Flick& f);

/// Speed at the start again, v0 √((sin θ − μ_d cos θ)/(sin θ + μ_d cos θ)) [m/s]; 0 if it stays.
[[nodiscard]] double return_speed(const Flick& f);

/// Time from the stop until then [s]; 0 if it stays.
[[nodiscard]] double return_time(const Flick& f);

/// C04. A block on a table is pulled with F = r t. L1.
struct LoadRamp {
  double mass{0.2};      ///< [kg]
  double rate{2};        ///< r [N/s]
  double gravity{9.81};  ///< [m/s²]
  Friction friction{0.6, 0.4};
};

/// t_s = μ_s m g / r [s].
[[nodiscard]] double slip_onset(const LoadRamp& l);

/// With τ = t − t_s > 0, (μ_s − μ_d) g τ²/2 + r τ³/(6 m) [m], and its derivative [m/s]; 0 before.
[[nodiscard]] double distance(const LoadRamp& l, double t);
[[nodiscard]] double speed(const LoadRamp& l, double t);

/// A block on a slope with sliding velocity at an angle to the fall line: the direction of kinetic friction turns all
/// the way. L1. With φ from downhill, v' = G cos φ − μ g cos θ, v φ' = −G sin φ, G = g sin θ; with τ = tan(φ/2) and
/// k = μ/tan θ,
///   v = c τ^(k−1) (1 + τ²), c = v0 sin φ0/(2 τ0^k), dt = −v dτ/(G τ),
/// so that time and place are sums of powers of τ. For k > 1 it stops (τ → 0, straight downhill). k not 1, 1/2.
struct ObliqueSlide {
  double slope{0.4};     ///< θ [rad]
  double mu{0.5};        ///< μ_d
  double speed{1};       ///< v0 [m/s]
  double angle{1.5};     ///< φ0, 0 to π [rad]
  double gravity{9.81};  ///< [m/s²]
};

/// When the angle has fallen to φ, and the speed and the ways downhill and across then; φ = 0: the stop (k > 1).
struct ObliquePoint {
  double t{};                   ///< [s]
  double downhill{}, across{};  ///< [m]
  double speed{};               ///< [m/s]
};

[[nodiscard]] ObliquePoint at_angle(const ObliqueSlide& s, double angle);

}  // namespace handhold::closed_form
