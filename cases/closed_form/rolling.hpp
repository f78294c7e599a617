// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace handhold::closed_form {

/// E01, E02. A ball on a level floor starts with any velocity and spin, slides, and ends up rolling. L1, contact in a
/// point (no torque about the normal). The direction of sliding is constant (Coriolis 1835). z is up.
struct SlidingBall {
  double radius{0.03};                            ///< r [m]
  double beta{0.4};                               ///< I / (m r²)
  double mu{0.25};                                ///< μ_d
  Eigen::Vector2d velocity{1, 0};                 ///< v0 [m/s]
  Eigen::Vector3d spin{Eigen::Vector3d::Zero()};  ///< ω0 [rad/s]
  double gravity{9.81};                           ///< [m/s²]
};

/// u0 = v0 + ω0 × (−r z), of the ball's lowest point [m/s].
[[nodiscard]] Eigen::Vector2d sliding_velocity(const SlidingBall& b);

/// |u0| / (μ g (1 + 1/β)) [s].
[[nodiscard]] double roll_time(const SlidingBall& b);

/// (v0 + β r ω0 × z) / (1 + β) [m/s].
[[nodiscard]] Eigen::Vector2d roll_velocity(const SlidingBall& b);

/// v0 t − μ g û0 t²/2 while it slides, straight on after [m].
[[nodiscard]] Eigen::Vector2d position(const SlidingBall& b, double t);

/// Heat of the slide per mass, ½ u0² β / (1 + β) [J/kg].
[[nodiscard]] double heat_per_mass(const SlidingBall& b);

/// E03. A ball between two parallel plates, no weight: the lower one rests, the upper one presses with N and moves as
/// j t³/6. L1, μ_s = μ_d. The ball rolls on both at half the plate's speed; then the upper contact slips.
struct RolledBall {
  double mass{0.1};        ///< [kg]
  double radius{0.02};     ///< r [m]
  double beta{0.4};        ///< I / (m r²)
  double normal_force{1};  ///< N [N]
  double mu{0.4};
  double jerk{60};  ///< j [m/s³]
};

/// t_s = 4 μ N / (m j (1 + β)) [s]: the upper friction is m a (1 + β) / 4, the lower m a (1 − β) / 4.
[[nodiscard]] double slip_onset(const RolledBall& b);

/// Of the centre [m]: j t³/12 up to t_s, then uniformly accelerated with 2 μ N / (m (1 + β)). The angle turned is x/r.
[[nodiscard]] double position(const RolledBall& b, double t);

/// Travel of the plate less twice that of the centre [m].
[[nodiscard]] double slip(const RolledBall& b, double t);

/// E04. A ball at rest between plates that move at V1 (upper) and V2 (lower) from t = 0 on, pressed with N, no weight.
/// L1. Only V2 = 0, V2 = −V1 and V2 = V1 have these formulas; NaN else.
struct CarriedBall {
  double mass{0.1};        ///< [kg]
  double radius{0.02};     ///< r [m]
  double beta{0.5};        ///< I / (m r²), <= 1
  double normal_force{1};  ///< N [N]
  double mu{0.4};
  double upper{0.2}, lower{0};  ///< V1, V2 [m/s]
};

/// When it rolls on both: m (1 + β) |V1| / (4 μ N), β m |V1| / (2 μ N), m |V1| / (2 μ N) [s].
[[nodiscard]] double roll_time(const CarriedBall& b);

/// (V1 + V2) / 2 [m/s] and (V1 − V2) / (2 r) [rad/s].
[[nodiscard]] double roll_speed(const CarriedBall& b);
[[nodiscard]] double roll_spin(const CarriedBall& b);

/// Heat until then: the plates' work less the ball's energy [J].
[[nodiscard]] double heat(const CarriedBall& b);

/// E05. A ball let go at rest on a slope. L1, μ_s = μ_d.
struct RollDown {
  double radius{0.03};  ///< r [m]
  double beta{0.4};     ///< I / (m r²)
  double slope{0.5};    ///< θ [rad]
  double mu{0.3};
  double gravity{9.81};  ///< [m/s²]
};

/// tan θ <= (1 + 1/β) μ.
[[nodiscard]] bool rolls(const RollDown& b);

/// g sin θ / (1 + β), or g (sin θ − μ cos θ) [m/s²].
[[nodiscard]] double acceleration(const RollDown& b);

/// a / r, or μ g cos θ / (β r) [rad/s²].
[[nodiscard]] double angular_acceleration(const RollDown& b);

/// After `distance`: √(2 D / a) [s], and the spin then [rad/s].
[[nodiscard]] double time_at(const RollDown& b, double distance);
[[nodiscard]] double spin_at(const RollDown& b, double distance);

/// E07. A ball rolls to and fro in a gutter, let go at rest at an angle from the bottom. L1: a pendulum (pendulum.hpp),
/// θ'' = −Ω² sin θ with Ω² = g/((1 + β)(R − r)), as long as it does not slip.
struct GutterBall {
  double gutter{0.1};    ///< R [m]
  double radius{0.02};   ///< r [m]
  double beta{0.4};      ///< I / (m r²)
  double start{1};       ///< θ0 [rad]
  double gravity{9.81};  ///< [m/s²]
};

[[nodiscard]] double swing_frequency(const GutterBall& b);  ///< Ω [rad/s]

/// It rolls all the way iff μ is not below β/(1 + β) tan θ0.
[[nodiscard]] double needed_friction(const GutterBall& b);

/// Of the centre at the bottom: √(2 g (R − r)(1 − cos θ0)/(1 + β)) [m/s].
[[nodiscard]] double greatest_speed(const GutterBall& b);

}  // namespace handhold::closed_form
