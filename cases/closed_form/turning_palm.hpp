// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// C11. A small object at distance x from the hinge of a palm that is raised at a constant rate, θ = Ω t; it slides
/// towards the hinge. L1. In the palm's frame, N/m = g cos θ + 2 Ω x' (Coriolis) and
///   x'' − Ω² x = −g sin θ + μ_d N/m,
/// whose solution is c1 e^(l1 τ) + c2 e^(l2 τ) + P sin Ωt + Q cos Ωt with l = Ω (μ ± √(1 + μ²)).
/// Valid for x0 Ω² < μ_s g (else it slips outwards at once) and while N > 0.
struct TiltingPalm {
  double distance{0.08};  ///< x0 from the hinge [m]
  double rate{1.5};       ///< Ω > 0 [rad/s]
  double gravity{9.81};   ///< [m/s²]
  Friction friction{0.4, 0.4};
};

/// g sin θ = μ_s g cos θ + x0 Ω²: θ = φ + asin(x0 Ω² cos φ / g), φ = atan μ_s [rad]; it slips from θ/Ω on [s], which
/// C11 asks for.
[[nodiscard]] double onset_angle(const TiltingPalm& p);
[[nodiscard]] double slip_onset(const TiltingPalm& p);

/// x and x' at t, up to the hinge [m], [m/s].
[[nodiscard]] double place(const TiltingPalm& p, double t);
[[nodiscard]] double speed(const TiltingPalm& p, double t);

/// N/m at t [m/s²].
[[nodiscard]] double normal_acceleration(const TiltingPalm& p, double t);

/// C12. A small object on a level palm that is spun up about the vertical, φ = α t²/2, at distance R from its axis. L1.
struct SpunPalm {
  double radius{0.1};      ///< R [m]
  double acceleration{8};  ///< α, R α < μ_s g [rad/s²]
  double gravity{9.81};    ///< [m/s²]
  double mu_static{0.4};
};

/// √((ω² R)² + (α R)²) = μ_s g at ω = α t: t = [((μ_s g/(R α))² − 1)/α²]^(1/4) [s].
[[nodiscard]] double slip_onset(const SpunPalm& p);

/// Angle from the outward radius to the direction in which the object begins to slide on the palm, against the palm's
/// acceleration (−ω² R, α R) of that place: atan2(−α, ω²) [rad].
[[nodiscard]] double slip_direction(const SpunPalm& p);

/// Where a slide with μ_d < μ_s (else it begins in no direction) has led at t >= slip_onset, and its velocity, in W;
/// the object started at (R, 0). Integrated in the palm's frame (plane_slide.hpp): pedigree converged.
struct SpunPlace {
  Eigen::Vector2d p{}, v{};  ///< [m], [m/s]
};
[[nodiscard]] SpunPlace slide(const SpunPalm& p, double mu_dynamic, double t);

/// E06. A ball rolls on a level plate that turns at Ω: v' = κ Ω z × v with κ = β/(1 + β), a circle (Weltner, Am. J.
/// Phys. 47 (1979) 984). L1.
struct TurntableBall {
  double radius{0.02};               ///< r [m]
  double beta{0.4};                  ///< I / (m r²)
  double rate{5};                    ///< Ω [rad/s]
  Eigen::Vector2d place{0.03, 0};    ///< at t = 0, from the axis [m]
  Eigen::Vector2d velocity{0.1, 0};  ///< at t = 0 [m/s]
};

/// 2 π / (κ Ω) [s].
[[nodiscard]] double period(const TurntableBall& b);
[[nodiscard]] Eigen::Vector2d position(const TurntableBall& b, double t);  ///< [m]
[[nodiscard]] Eigen::Vector2d velocity(const TurntableBall& b, double t);  ///< [m/s]

/// Level angular velocity with which it rolls: r ω × z = v − Ω z × x [rad/s].
[[nodiscard]] Eigen::Vector2d spin(const TurntableBall& b, double t);

}  // namespace handhold::closed_form
