// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/shaken_pinch.hpp"

#include <cmath>

namespace handhold::closed_form {
namespace {

/// Z / A
double response(const ShakenPinch& p) {
  const double square = p.frequency * p.frequency;
  return square / (2 * p.stiffness / p.mass - square);
}

}  // namespace

double relative_amplitude(const ShakenPinch& p) { return p.amplitude * response(p); }

double relative_displacement(const ShakenPinch& p, double t) {
  return relative_amplitude(p) * std::sin(p.frequency * t);
}

double normal_force(const ShakenPinch& p, double t) { return p.stiffness * (p.preload + relative_displacement(p, t)); }

double critical_amplitude(const ShakenPinch& p) { return p.preload / response(p); }

double start_velocity(const ShakenPinch& p) { return (p.amplitude + relative_amplitude(p)) * p.frequency; }

}  // namespace handhold::closed_form
