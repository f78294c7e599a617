// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/moved_pinch.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace handhold::closed_form {
namespace {

using std::numbers::pi;

double limit(const VerticalShake& s, double mu) { return 2 * mu * s.normal_force / s.mass; }

double sliding_speed(const VerticalShake& s, double t) {
  const double t1 = slip_onset(s), w = s.frequency;
  return (limit(s, s.friction.mu_dynamic) - s.gravity) * (t - t1) -
         s.amplitude * w * (std::cos(w * t) - std::cos(w * t1));
}

double limit(const SideShake& s) { return 2 * s.mu_static * s.normal_force / s.mass; }

}  // namespace

double stop_time(const PinchCatch& p) {
  const double b = p.gravity - 2 * p.friction.mu_dynamic * p.normal_force / p.mass;
  const double c = 2 * p.friction.mu_dynamic * p.rate / p.mass;
  return (b + std::sqrt(b * b + 2 * c * p.speed)) / c;
}

double slip(const PinchCatch& p) {
  const double b = p.gravity - 2 * p.friction.mu_dynamic * p.normal_force / p.mass;
  const double c = 2 * p.friction.mu_dynamic * p.rate / p.mass, t = stop_time(p);
  return t * (p.speed + t * (b / 2 - t * c / 6));
}

double greatest_acceleration(const VerticalShake& s) { return limit(s, s.friction.mu_static) - s.gravity; }

bool slips(const VerticalShake& s) { return s.amplitude * s.frequency * s.frequency > greatest_acceleration(s); }

double slip_onset(const VerticalShake& s) {
  if (!slips(s)) return std::numeric_limits<double>::quiet_NaN();
  return (pi + std::asin(greatest_acceleration(s) / (s.amplitude * s.frequency * s.frequency))) / s.frequency;
}

double stop_time(const VerticalShake& s) {
  if (!slips(s)) return std::numeric_limits<double>::quiet_NaN();
  // It slides downwards from t1 on: step until the speed is back at zero, then bisect.
  const double step = 1e-3 / s.frequency;
  double a = slip_onset(s) + step;
  while (sliding_speed(s, a + step) < 0) a += step;
  double b = a + step;
  for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b)) (sliding_speed(s, m) < 0 ? a : b) = m;
  return b;
}

double slip(const VerticalShake& s) {
  if (!slips(s)) return 0;
  const double t1 = slip_onset(s), t2 = stop_time(s), tau = t2 - t1, w = s.frequency;
  return (limit(s, s.friction.mu_dynamic) - s.gravity) * tau * tau / 2 -
         s.amplitude * (std::sin(w * t2) - std::sin(w * t1)) + s.amplitude * w * std::cos(w * t1) * tau;
}

bool holds(const SideShake& s) { return std::hypot(s.gravity, s.amplitude * s.frequency * s.frequency) <= limit(s); }

double slip_onset(const SideShake& s) {
  return std::asin(-acceleration_at_onset(s) / (s.amplitude * s.frequency * s.frequency)) / s.frequency;
}

double acceleration_at_onset(const SideShake& s) { return -std::sqrt(limit(s) * limit(s) - s.gravity * s.gravity); }

Eigen::Vector2d slip_direction(const SideShake& s) {
  return Eigen::Vector2d(-acceleration_at_onset(s), -s.gravity) / limit(s);
}

PlaneSlide slide(const SideShake& s, double mu_dynamic, double t) {
  const auto drive = [&](double time, const Eigen::Vector2d&, const Eigen::Vector2d&) -> Eigen::Vector2d {
    return {s.amplitude * s.frequency * s.frequency * std::sin(s.frequency * time), -s.gravity};
  };
  return slide_from_rest(drive, 2 * mu_dynamic * s.normal_force / s.mass, slip_onset(s), slip_direction(s), t);
}

}  // namespace handhold::closed_form
