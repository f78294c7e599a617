// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/landing.hpp"

#include <cmath>

namespace handhold::closed_form {
namespace {

double sliding(const Landing& l) { return l.velocity - l.radius * l.spin; }

/// Tangential impulse per mass that would stop the sliding.
double stopping(const Landing& l) { return l.beta > 0 ? sliding(l) / (1 + 1 / l.beta) : sliding(l); }

double kinetic_per_mass(const Landing& l, double v, double w) {
  return (v * v + l.beta * l.radius * l.radius * w * w) / 2;
}

}  // namespace

double landing_time(const Landing& l) { return std::sqrt(2 * l.height / l.gravity); }

double landing_speed(const Landing& l) { return std::sqrt(2 * l.gravity * l.height); }

bool grips(const Landing& l) { return std::abs(stopping(l)) <= l.friction.mu_static * landing_speed(l); }

double velocity_after(const Landing& l) {
  if (grips(l)) return l.velocity - stopping(l);
  return l.velocity - std::copysign(l.friction.mu_dynamic * landing_speed(l), sliding(l));
}

double spin_after(const Landing& l) {
  return l.beta > 0 ? l.spin - (velocity_after(l) - l.velocity) / (l.beta * l.radius) : l.spin;
}

double impact_loss_per_mass(const Landing& l) {
  return l.gravity * l.height + kinetic_per_mass(l, l.velocity, l.spin) -
         kinetic_per_mass(l, velocity_after(l), spin_after(l));
}

}  // namespace handhold::closed_form
