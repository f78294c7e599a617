// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/spin_down.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handhold::closed_form {

double lag(const SpinDown& s) { return s.stiffness > 0 ? s.mu * s.normal_force / s.stiffness : 0; }

double torque(const SpinDown& s, PatchShape shape) {
  const double full = 2 * s.mu * s.normal_force * s.radius;
  switch (shape) {
    case PatchShape::ring:
      return full * std::sqrt(1 - std::pow(lag(s) / s.radius, 2));
    case PatchShape::disc:
      return full * 2 / 3;
    case PatchShape::hertz:
      return full * 3 * std::numbers::pi / 16;
  }
  return 0;
}

double stop_time(const SpinDown& s, PatchShape shape) { return s.inertia * s.spin / torque(s, shape); }

double stop_angle(const SpinDown& s, PatchShape shape) { return s.inertia * s.spin * s.spin / (2 * torque(s, shape)); }

double angle(const SpinDown& s, PatchShape shape, double t) {
  const double until = std::min(t, stop_time(s, shape));
  return s.spin * until - torque(s, shape) / s.inertia * until * until / 2;
}

}  // namespace handhold::closed_form
