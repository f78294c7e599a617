// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// D01. An object pinched by `fingers` vertical faces pressed with `normal_force` each, the hand accelerating upwards
/// from rest at t = 0. L1; the compliant element gives the same motion when its springs start at the load of that
/// acceleration.
struct Pinch {
  int fingers{2};
  double normal_force{2.5};  ///< N of each finger [N]
  double mass{0.2};          ///< [kg]
  double acceleration{1};    ///< a of the hand, up [m/s²]
  double gravity{9.81};      ///< [m/s²]
  Friction friction{};
};

/// n μ_s N >= m (g + a).
[[nodiscard]] bool holds(const Pinch& pinch);

/// How far the object has slid down in the hand at time t: ½ (g + a − n μ_d N / m) t² [m], 0 if it holds.
[[nodiscard]] double slip(const Pinch& pinch, double t);

/// The normal force of each finger at which the object just holds: m (g + a) / (n μ_s) [N].
[[nodiscard]] double critical_normal_force(const Pinch& pinch);

/// D02. Two fingers open so that N(t) = N0 − r t of each; the hand stays. The object starts to slip, and falls under
/// decaying friction until the fingers are empty. L1 = L2 for undamped springs that start at the load m g.
struct PinchOpening {
  double mass{0.2};        ///< [kg]
  double normal_force{4};  ///< N0 of each finger [N]
  double rate{2};          ///< r [N/s]
  double gravity{9.81};    ///< [m/s²]
  Friction friction{};
};

/// t_s = (N0 − m g / (2 μ_s)) / r [s].
[[nodiscard]] double slip_onset(const PinchOpening& opening);

/// t_open = N0 / r [s].
[[nodiscard]] double open_time(const PinchOpening& opening);

/// Distance fallen at time t [m]: with τ = t − t_s, g (1 − μ_d/μ_s) τ²/2 + μ_d r τ³/(3 m); free fall once the fingers
/// are empty.
[[nodiscard]] double fall(const PinchOpening& opening, double t);

/// Its time derivative [m/s].
[[nodiscard]] double fall_speed(const PinchOpening& opening, double t);

}  // namespace handhold::closed_form
