// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// C01. A block on a palm tilted by `slope`, let go at rest at t = 0. L1; the compliant element gives the same motion
/// when it starts at rest on its cone, since neither N nor the kinetic friction then changes.
struct Incline {
  double slope{0.5};     ///< θ [rad], 0 to π/2
  double gravity{9.81};  ///< [m/s²]
  Friction friction{};
};

/// True while the block stays: tan θ <= μ_s.
[[nodiscard]] bool holds(const Incline& incline);

/// a = g (sin θ − μ_d cos θ) [m/s²], 0 if it holds.
[[nodiscard]] double acceleration(const Incline& incline);

/// Distance slid down the plane at time t: ½ a t² [m].
[[nodiscard]] double slip(const Incline& incline, double t);

/// Time to slide `distance`: √(2 D / a) [s]; infinite if it holds.
[[nodiscard]] double time_at(const Incline& incline, double distance);

/// Speed there: √(2 a D) [m/s].
[[nodiscard]] double speed_at(const Incline& incline, double distance);

}  // namespace handhold::closed_form
