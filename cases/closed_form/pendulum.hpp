// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// θ'' = −Ω² sin θ, of a weight on a rod as of a body that turns against springs fixed in space. Swinging only: it
/// never goes over the top.

/// θ(t) from θ = 0 with speed `spin`, |spin| < 2 Ω: sin(θ/2) = κ sn(Ω t, κ), κ = spin / (2 Ω) [rad].
[[nodiscard]] double swing_from_bottom(double frequency, double spin, double t);

/// θ(t) from rest at `start`, |start| < π: sin(θ/2) = κ cd(Ω t, κ), κ = sin(start / 2) [rad].
[[nodiscard]] double swing_from_rest(double frequency, double start, double t);

/// When a swing from θ = 0 with speed `spin` > 0 first reaches `angle` > 0, up or, if it never gets there, NaN [s].
[[nodiscard]] double time_to_angle(double frequency, double spin, double angle);

/// 4 K(sin(start / 2)) / Ω [s].
[[nodiscard]] double swing_period(double frequency, double start);

}  // namespace handhold::closed_form
