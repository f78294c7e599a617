// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/stopping.hpp"

#include <cmath>

namespace handhold::closed_form {
namespace {

double kinetic_lag(const Stopping& s) { return s.stiffness > 0 ? s.mu_dynamic * s.mass * s.gravity / s.stiffness : 0; }

}  // namespace

double stop_time(const Stopping& s) { return s.speed / (s.mu_dynamic * s.gravity); }

double stop_distance(const Stopping& s) { return s.speed * s.speed / (2 * s.mu_dynamic * s.gravity); }

double heat(const Stopping& s) { return 0.5 * s.mass * s.speed * s.speed; }

double distance(const Stopping& s, double t) {
  const double tau = t - stop_time(s);
  if (tau < 0) return s.speed * t - 0.5 * s.mu_dynamic * s.gravity * t * t;
  const double rho = kinetic_lag(s);
  if (rho == 0) return stop_distance(s);
  const double delta = s.damping / (2 * s.mass);
  const double omega = std::sqrt(s.stiffness / s.mass - delta * delta);
  const double ring = std::exp(-delta * tau) * (std::cos(omega * tau) + delta / omega * std::sin(omega * tau));
  return stop_distance(s) - rho + rho * ring;
}

double rest_distance(const Stopping& s) { return stop_distance(s) - kinetic_lag(s); }

}  // namespace handhold::closed_form
