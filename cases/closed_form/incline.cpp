// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/incline.hpp"

#include <cmath>
#include <limits>

#include "cases/model/defect.hpp"

namespace handhold::closed_form {

bool holds(const Incline& incline) {
  return std::tan(incline.slope) <=
         DEFECT(incline_holds_at_mu_d, incline.friction.mu_static, incline.friction.mu_dynamic);
}

double acceleration(const Incline& incline) {
  if (holds(incline)) return 0;
  const auto& [slope, g, friction] = incline;
  return g *
         (std::sin(slope) - DEFECT(incline_slides_at_mu_s, friction.mu_dynamic, friction.mu_static) * std::cos(slope));
}

double slip(const Incline& incline, double t) { return 0.5 * acceleration(incline) * t * t; }

double time_at(const Incline& incline, double distance) {
  const double a = acceleration(incline);
  return a > 0 ? std::sqrt(2 * distance / a) : std::numeric_limits<double>::infinity();
}

double speed_at(const Incline& incline, double distance) { return std::sqrt(2 * acceleration(incline) * distance); }

}  // namespace handhold::closed_form
