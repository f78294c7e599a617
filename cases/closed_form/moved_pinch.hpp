// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "cases/closed_form/plane_slide.hpp"
#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// D03. An object slips down at v0 between two fingers that close: N(t) = N0 + r t each. L1.
struct PinchCatch {
  double mass{0.2};        ///< [kg]
  double normal_force{1};  ///< N0 of each finger [N], 2 μ_d N0 < m g
  double rate{8};          ///< r > 0 [N/s]
  double speed{0.3};       ///< v0 [m/s]
  double gravity{9.81};    ///< [m/s²]
  Friction friction{};
};

/// t = (b + √(b² + 2 c v0)) / c, b = g − 2 μ_d N0/m, c = 2 μ_d r/m [s].
[[nodiscard]] double stop_time(const PinchCatch& p);

/// v0 t + b t²/2 − c t³/6 there [m]. It stays from then on.
[[nodiscard]] double slip(const PinchCatch& p);

/// D04. Two fingers press with N each and shake vertically, y = A sin ωt. L1. With c = 2 μ N/m: one slip a cycle, down,
/// while the hand accelerates upwards; holds for c_s − g < A ω² <= c_s + g, and a stop before the next onset.
struct VerticalShake {
  double mass{0.2};          ///< [kg]
  double normal_force{2.6};  ///< N [N]
  double amplitude{0.02};    ///< A [m]
  double frequency{20};      ///< ω [rad/s]
  double gravity{9.81};      ///< [m/s²]
  Friction friction{};
};

/// The greatest acceleration of the hand without slip, c_s − g [m/s²].
[[nodiscard]] double greatest_acceleration(const VerticalShake& s);
[[nodiscard]] bool slips(const VerticalShake& s);

/// t1 = (π + asin((c_s − g)/(A ω²)))/ω [s].
[[nodiscard]] double slip_onset(const VerticalShake& s);

/// t2, the zero after t1 of u(t) = (c_d − g)(t − t1) − A ω (cos ωt − cos ωt1), to the last bit [s].
[[nodiscard]] double stop_time(const VerticalShake& s);

/// Way of the object in the hand in a cycle, upwards [m].
[[nodiscard]] double slip(const VerticalShake& s);

/// D06. Two fingers press with N each along y and shake sideways, x = A sin ωt, while they hold the weight: the cone
/// limits the sum of both loads. L1.
struct SideShake {
  double mass{0.2};          ///< [kg]
  double normal_force{2.6};  ///< N [N]
  double amplitude{0.05};    ///< A [m]
  double frequency{15};      ///< ω [rad/s]
  double gravity{9.81};      ///< [m/s²]
  double mu_static{0.5};
};

/// g² + (A ω²)² <= (2 μ_s N/m)².
[[nodiscard]] bool holds(const SideShake& s);

/// sin ωt = √(c² − g²)/(A ω²) [s].
[[nodiscard]] double slip_onset(const SideShake& s);

/// Acceleration of the hand then, along x [m/s²]; negative.
[[nodiscard]] double acceleration_at_onset(const SideShake& s);

/// Unit direction (x, z) in which the object begins to slide in the hand: against the friction it had, (a, g).
[[nodiscard]] Eigen::Vector2d slip_direction(const SideShake& s);

/// The object's slide in the hand with μ_d at t >= slip_onset, coordinates (x, z): its friction turns with its
/// direction. Integrated (plane_slide.hpp): pedigree converged.
[[nodiscard]] PlaneSlide slide(const SideShake& s, double mu_dynamic, double t);

}  // namespace handhold::closed_form
