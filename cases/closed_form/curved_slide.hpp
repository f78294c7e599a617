// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// C14. A small object slides off a dome (sphere or lying cylinder), angle θ from the top, μ_s = μ_d. L1. With w = v²
/// and N = m (g cos θ − w/R), dw/dθ = 2 g R sin θ − 2 μ (g R cos θ − w) is linear:
///   w = C e^(2μθ) + P cos θ + Q sin θ,  P = 2 g R (2μ² − 1)/(1 + 4μ²),  Q = −6 μ g R/(1 + 4μ²)
/// (Mungan, The Physics Teacher, 2003).
struct Dome {
  double radius{0.1};  ///< R [m]
  double mu{0.3};
  double start_angle{0.35};  ///< θ0 > 0 [rad]
  double start_speed{0};     ///< downhill; 0: tan θ0 > μ [m/s]
  double gravity{9.81};      ///< [m/s²]
};

/// v²(θ) [m²/s²]; serves the lift-off below.
[[nodiscard]] double speed_squared(const Dome& d, double angle);

/// Where it lifts off, w = g R cos θ, to the last bit [rad]; NaN if it stops before.
[[nodiscard]] double lift_off_angle(const Dome& d);

/// [m/s], [s] (∫ R dθ/v by quadrature, 1e-14).
[[nodiscard]] double lift_off_speed(const Dome& d);
[[nodiscard]] double lift_off_time(const Dome& d);

/// C15. A small object slides in a bowl or gutter, angle θ from the bottom, let go at rest. L1. For a swing towards
/// growing a = ±θ, w = C e^(−2μa) + A cos a + B sin a with A = 2 g R (1 − 2μ²)/(1 + 4μ²), B = −6 μ g R/(1 + 4μ²).
struct Bowl {
  double radius{0.08};      ///< R [m]
  double start_angle{1.2};  ///< |θ0| < π/2 [rad]
  double gravity{9.81};     ///< [m/s²]
  Friction friction{0.25, 0.2};
};

/// Angles at which it comes to a stop, the start first, the last one where it stays (tan |θ| <= μ_s) [rad].
[[nodiscard]] std::vector<double> turning_angles(const Bowl& b);

/// When, by quadrature (1e-13) [s].
[[nodiscard]] std::vector<double> turning_times(const Bowl& b);

/// C16. A puck slides along the inside of a circular wall on a rough floor. L1. dv/dt = −(μ_w/R) v² − μ_f g.
struct WallSlide {
  double radius{0.15};  ///< R [m]
  double mu_wall{0.3}, mu_floor{0.2};
  double speed{1.5};     ///< v0 [m/s]
  double gravity{9.81};  ///< [m/s²]
};

/// atan(v0 √(b/a)) / √(ab), a = μ_f g, b = μ_w/R [s].
[[nodiscard]] double stop_time(const WallSlide& w);

/// ln(1 + μ_w v0²/(μ_f g R)) / (2 μ_w) [rad].
[[nodiscard]] double swept_angle(const WallSlide& w);

/// Up to the stop: √(a/b) tan(atan(v0 √(b/a)) − √(ab) t) [m/s], and the angle swept until t [rad].
[[nodiscard]] double speed_at(const WallSlide& w, double t);
[[nodiscard]] double angle_at(const WallSlide& w, double t);

}  // namespace handhold::closed_form
