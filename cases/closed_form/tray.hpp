// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace handhold::closed_form {

/// G07. A rigid tray with its centre of mass off the middle rests on four equal samples at (±a, ±b), slack sideways
/// when it lay level. L2: all samples stick, so each is a spring k from a point of the tray to a point in space, and
/// the tray leans until they balance.
struct Tray {
  double mass{0.4};          ///< [kg]
  double a{0.05}, b{0.03};   ///< [m]
  double x{0.01}, y{0.005};  ///< of the centre of mass [m]
  double height{1.0 / 64};   ///< of the centre of mass above the tray's underside [m]
  double stiffness{2000};    ///< k of each sample [N/m]
  double gravity{9.81};      ///< [m/s²]
};

/// Vertical forces at (+a, +b), (+a, −b), (−a, +b), (−a, −b), the tray leaning as it does (exact; iterated to the last
/// bit) [N].
[[nodiscard]] std::array<double, 4> vertical_forces(const Tray& tray);

/// A limit that the forces above are tested against, no case being that stiff. The same for a lean that tends to 0,
/// k → ∞: m g (1/4 + x x_i / (4 a²) + y y_i / (4 b²)) [N].
[[nodiscard]] std::array<double, 4> level_forces(const Tray& tray);

/// L1: balance leaves the forces of four rigid points undetermined; the first may lie between these [N]. Bounds are no
/// truth that a claim could state; the forces above are tested to lie between them.
struct Bounds {
  double low{}, high{};
};
[[nodiscard]] Bounds rigid_bounds(const Tray& tray);

}  // namespace handhold::closed_form
