// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/incline.hpp"

#include <cmath>
#include <limits>

namespace handhold::closed_form {

bool holds(const Incline& incline) { return std::tan(incline.slope) <= incline.friction.mu_static; }

double acceleration(const Incline& incline) {
  if (holds(incline)) return 0;
  const auto& [slope, g, friction] = incline;
  return g * (std::sin(slope) - friction.mu_dynamic * std::cos(slope));
}

double slip(const Incline& incline, double t) { return 0.5 * acceleration(incline) * t * t; }

double time_at(const Incline& incline, double distance) {
  const double a = acceleration(incline);
  return a > 0 ? std::sqrt(2 * distance / a) : std::numeric_limits<double>::infinity();
}

double speed_at(const Incline& incline, double distance) { return std::sqrt(2 * acceleration(incline) * distance); }

}  // namespace handhold::closed_form
