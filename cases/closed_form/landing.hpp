// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cases/model/friction.hpp"

namespace handhold::closed_form {

/// B02. A block or a ball falls from rest in height on a level floor with a level velocity and spin; plastic impact
/// (restitution 0) under Coulomb friction (Routh 1860; Stronge, Impact Mechanics, ch. 3). L1. x is level, the spin
/// about y: the lowest point slides at u = v − r ω.
struct Landing {
  double height{0.05};   ///< h of the lowest point [m]
  double velocity{0.3};  ///< v along x [m/s]
  double spin{};         ///< ω about y [rad/s]
  double beta{};         ///< I / (m r²); 0: a block that does not turn
  double radius{};       ///< r of a ball [m]
  double gravity{9.81};  ///< [m/s²]
  Friction friction{};
};

/// √(2 h/g) [s] and √(2 g h) [m/s].
[[nodiscard]] double landing_time(const Landing& l);
[[nodiscard]] double landing_speed(const Landing& l);

/// The impulse that stops the sliding, m |u|/(1 + 1/β) (a block: m |u|), lies in the cone: <= μ_s m √(2 g h).
[[nodiscard]] bool grips(const Landing& l);

/// Just after: v − u/(1 + 1/β) if it grips, else v ∓ μ_d √(2 g h) [m/s]; ω changes by −Δv/(β r) [rad/s].
[[nodiscard]] double velocity_after(const Landing& l);
[[nodiscard]] double spin_after(const Landing& l);

/// Energy that the impact takes, per mass [J/kg].
[[nodiscard]] double impact_loss_per_mass(const Landing& l);

}  // namespace handhold::closed_form
