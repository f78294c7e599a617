// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// C05. A block on a table under a force F0 sin ωt. L1. It slips once in every half cycle; the formulas hold while it
/// stops before the next breakaway, which has the opposite direction.
struct HarmonicForce {
  double mass{0.2};      ///< [kg]
  double force{1.4};     ///< F0 [N]
  double frequency{10};  ///< ω [rad/s]
  double gravity{9.81};  ///< [m/s²]
  Friction friction{};
};

/// F0 > μ_s m g.
[[nodiscard]] bool slips(const HarmonicForce& h);

/// t1 = asin(μ_s m g / F0) / ω [s]; NaN if it does not slip.
[[nodiscard]] double slip_onset(const HarmonicForce& h);

/// t2, the zero of v(t) = F0/(m ω) (cos ωt1 − cos ωt) − μ_d g (t − t1) after t1, to the last bit [s].
[[nodiscard]] double stop_time(const HarmonicForce& h);

/// Way slipped from t1 to t2 [m].
[[nodiscard]] double slip(const HarmonicForce& h);

/// C06. A block on a table, tied to the origin by a spring, let go at x0 at rest. L1.
struct FrictionOscillator {
  double mass{0.2};      ///< [kg]
  double stiffness{50};  ///< k [N/m]
  double start{0.1};     ///< x0 [m]
  double gravity{9.81};  ///< [m/s²]
  Friction friction{};
};

/// x_j = (−1)^j (x0 − 2 j μ_d m g / k), for j up to half_swings() [m] (Lorenz 1924; Marchewka et al., Am. J. Phys. 72
/// (2004) 477).
[[nodiscard]] double turning_point(const FrictionOscillator& o, int j);

/// The first j at which it stays: |x_j| <= μ_s m g / k.
[[nodiscard]] int half_swings(const FrictionOscillator& o);

/// half_swings() π √(m/k) [s].
[[nodiscard]] double stop_time(const FrictionOscillator& o);

/// C07. A block on a table, tied to the origin by a spring, under a force F0 cos(ωt + φ) with φ chosen such that t = 0
/// is at x = +X, at rest. Steady motion without stops (Den Hartog 1931), μ_s = μ_d. L1.
struct DenHartog {
  double mass{0.2};      ///< [kg]
  double stiffness{50};  ///< k [N/m]
  double force{1};       ///< F0 [N]
  double frequency{10};  ///< ω, not √(k/m) [rad/s]
  double mu{0.2};
  double gravity{9.81};  ///< [m/s²]
};

/// X = √(A² − (f U)²) with A = F0/k / (1 − ω²/ωn²), f = μ m g / k, U = β sin πβ / (1 + cos πβ), β = ωn/ω [m]; NaN if
/// there is no such motion.
[[nodiscard]] double amplitude(const DenHartog& d);

/// φ: sin φ = −f U / A, cos φ = X / A [rad].
[[nodiscard]] double phase(const DenHartog& d);

/// x(t) for t >= 0; x(t + π/ω) = −x(t) [m].
[[nodiscard]] double position(const DenHartog& d, double t);

/// 4 μ m g X of a cycle [J].
[[nodiscard]] double dissipation(const DenHartog& d);

/// C08. A block on a belt of speed V, tied to the origin by a spring; its limit cycle, from a re-stick at t = 0. L1,
/// μ_s > μ_d.
struct BeltOscillator {
  double mass{0.2};      ///< [kg]
  double stiffness{50};  ///< k [N/m]
  double speed{0.05};    ///< V > 0 [m/s]
  double gravity{9.81};  ///< [m/s²]
  Friction friction{0.6, 0.4};
};

/// x at a re-stick: x_d − Δ, with x_d = μ_d m g / k, Δ = (μ_s − μ_d) m g / k [m].
[[nodiscard]] double restick_position(const BeltOscillator& b);

/// 2 Δ / V [s].
[[nodiscard]] double stick_time(const BeltOscillator& b);

/// (2/ωn) (π − atan(ωn Δ / V)) [s].
[[nodiscard]] double slip_time(const BeltOscillator& b);

/// x_d ± √(Δ² + (V/ωn)²) [m].
[[nodiscard]] double greatest_position(const BeltOscillator& b);
[[nodiscard]] double least_position(const BeltOscillator& b);

/// x(t) within the first cycle [m].
[[nodiscard]] double position(const BeltOscillator& b, double t);

/// C09. An object on a palm that moves as x = A sin ωt; μ_s = μ_d. L1.
struct OscillatingPalm {
  double amplitude{0.05};  ///< A [m]
  double frequency{20};    ///< ω [rad/s]
  double mu{0.4};
  double gravity{9.81};  ///< [m/s²]
};

/// A ω² <= μ g.
[[nodiscard]] bool sticks(const OscillatingPalm& p);

/// (A ω²)² >= (μ g)² (1 + π²/4): in the steady motion it never sticks. Between the two it sticks and slips.
/// Tells where the following have a value; no number of a case.
[[nodiscard]] bool slides_throughout(const OscillatingPalm& p);

/// Peak of the object's steady speed: π μ g / (2 ω), a triangle wave, when it slides throughout; A ω when it sticks;
/// NaN between [m/s].
[[nodiscard]] double peak_speed(const OscillatingPalm& p);

/// Phase ωt at which friction turns from forwards to backwards: cos = π μ g / (2 A ω²) [rad]; NaN unless it slides
/// throughout.
[[nodiscard]] double switching_phase(const OscillatingPalm& p);

/// Way slid in a cycle, both ways together: 4 A sin(switching phase) [m].
[[nodiscard]] double slip_per_cycle(const OscillatingPalm& p);

}  // namespace handhold::closed_form
