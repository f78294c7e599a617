// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/off_centre_pinch.hpp"

#include <algorithm>
#include <cmath>

namespace handhold::closed_form {

double half_period(const OffCentrePinch& p, double start) {
  return 2 * std::comp_ellint_1(std::sin(start / 2)) * std::sqrt(p.inertia / (p.mass * p.gravity * p.arm));
}

double turning_angle(const OffCentrePinch& p, double start) {
  const double weight = p.mass * p.gravity * p.arm;
  if (weight * std::sin(start) <= p.torque) return start;
  // Kinetic energy at φ: rises from 0 at the start to its greatest where m g l sin φ = T, then falls to 0 once.
  const auto kinetic = [&](double phi) {
    return weight * (std::cos(phi) - std::cos(start)) - p.torque * (start - phi);
  };
  double moving = std::asin(std::min(1.0, p.torque / weight)), stopped = -start;
  for (int i = 0; i < 100; ++i) {
    const double middle = (moving + stopped) / 2;
    (kinetic(middle) > 0 ? moving : stopped) = middle;
  }
  return stopped;
}

}  // namespace handhold::closed_form
