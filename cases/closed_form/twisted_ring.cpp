// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/twisted_ring.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/closed_form/pursuit.hpp"

namespace handhold::closed_form {
namespace {

double normal_force_each(const TwistedRing& r) { return r.normal_force / r.samples; }

double sample_torque(const TwistedRing& r, double D, double angle) {
  const double slip = slip_angle(r, D);
  if (!(angle > slip)) return r.stiffness * D * D * std::sin(angle);
  const double friction = r.friction.mu_dynamic * normal_force_each(r);
  const double ratio = D * r.stiffness / friction;
  return friction * D * std::cos(pursuit_angle(ratio, slip / 2, angle - slip));
}

}  // namespace

std::vector<double> distances(const TwistedRing& r) {
  std::vector<double> D;
  for (int i = 0; i < r.samples; ++i) {
    const double angle = 2 * std::numbers::pi * i / r.samples;
    D.push_back(std::hypot(r.radius * std::cos(angle) - r.offset, r.radius * std::sin(angle)));
  }
  return D;
}

double slip_angle(const TwistedRing& r, double distance) {
  return 2 * std::asin(r.friction.mu_static * normal_force_each(r) / (2 * r.stiffness * distance));
}

double first_slip_angle(const TwistedRing& r) {
  const auto D = distances(r);
  return slip_angle(r, *std::max_element(D.begin(), D.end()));
}

double last_slip_angle(const TwistedRing& r) {
  const auto D = distances(r);
  return slip_angle(r, *std::min_element(D.begin(), D.end()));
}

int slipping(const TwistedRing& r, double angle) {
  const auto D = distances(r);
  return int(std::count_if(D.begin(), D.end(), [&](double d) { return angle > slip_angle(r, d); }));
}

double torque(const TwistedRing& r, double angle) {
  double sum = 0;
  for (const double D : distances(r)) sum += sample_torque(r, D, angle);
  return sum;
}

double linear_torque(const TwistedRing& r, double angle) {
  double sum = 0;
  for (const double D : distances(r))
    sum += std::min(r.stiffness * angle * D, r.friction.mu_dynamic * normal_force_each(r)) * D;
  return sum;
}

}  // namespace handhold::closed_form
