// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/held_cube.hpp"

#include <cmath>

namespace handhold::closed_form {

double inertia(const HeldCube& c) { return c.mass * c.edge * c.edge / 6; }

double translation_frequency(const HeldCube& c) { return std::sqrt(2 * c.stiffness / c.mass); }

double roll_frequency(const HeldCube& c) {
  const double face = c.edge / 2;
  const double arms = face * (face - c.depth) + c.radius * c.radius / 2;  // of the anchor times that of the sample
  return std::sqrt(2 * c.stiffness * arms / inertia(c));
}

double spin_frequency(const HeldCube& c) { return std::sqrt(2 * c.stiffness * c.radius * c.radius / inertia(c)); }

double sag(const HeldCube& c) { return c.mass * c.gravity / (2 * c.stiffness); }

}  // namespace handhold::closed_form
