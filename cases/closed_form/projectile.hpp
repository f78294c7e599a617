// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// A01. A body thrown from the origin; no contact.
struct Projectile {
  double speed{0.6};     ///< level [m/s]
  double climb{1.1};     ///< upwards [m/s]
  double gravity{9.81};  ///< [m/s²]
};

[[nodiscard]] constexpr double distance(const Projectile& p, double t) { return p.speed * t; }

/// v_z t − ½ g t² [m].
[[nodiscard]] constexpr double height(const Projectile& p, double t) { return t * (p.climb - 0.5 * p.gravity * t); }

[[nodiscard]] constexpr double climb_at(const Projectile& p, double t) { return p.climb - p.gravity * t; }

/// When and where it is highest: v_z / g [s], v_z² / (2 g) [m].
[[nodiscard]] constexpr double apex_time(const Projectile& p) { return p.climb / p.gravity; }
[[nodiscard]] constexpr double apex_height(const Projectile& p) { return p.climb * p.climb / (2 * p.gravity); }

}  // namespace handhold::closed_form
