// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/pulled_grip.hpp"

#include <cmath>

namespace handhold::closed_form {
namespace {

double frequency(const PulledGrip& g) { return std::sqrt(2 * g.stiffness / g.mass); }

double slip_acceleration(const PulledGrip& g) { return 2 * g.friction.mu_dynamic * g.stiffness * g.depth / g.mass; }

}  // namespace

double breakaway_time(const PulledGrip& g) {
  const double w = frequency(g);
  return std::asin(g.friction.mu_static * g.depth * w / g.speed) / w;
}

double restick_time(const PulledGrip& g) {
  const double t1 = breakaway_time(g);
  return t1 + g.speed * std::cos(frequency(g) * t1) / slip_acceleration(g);
}

double object_position(const PulledGrip& g, double t) {
  const double w = frequency(g), a = slip_acceleration(g), t1 = breakaway_time(g), t2 = restick_time(g);
  const auto drawn = [&](double s) { return g.speed * (s - std::sin(w * s) / w); };
  if (t <= t1) return drawn(t);
  const double v1 = g.speed * (1 - std::cos(w * t1));
  const auto slipping = [&](double s) { return drawn(t1) + v1 * (s - t1) + 0.5 * a * (s - t1) * (s - t1); };
  if (t <= t2) return slipping(t);
  const double lag = g.friction.mu_dynamic * g.depth;
  return slipping(t2) + g.speed * (t - t2) + lag * (1 - std::cos(w * (t - t2)));
}

double depth(const BreathingGrip& g, double t) { return g.mean + g.swing * std::cos(g.rate * t); }

double slip_onset(const BreathingGrip& g) {
  const double closed = g.mass * g.gravity / (2 * g.friction.mu_static * g.stiffness);  // depth at which it just holds
  return std::acos((closed - g.mean) / g.swing) / g.rate;
}

double height(const BreathingGrip& g, double t) {
  const double t1 = slip_onset(g), s = t - t1, w = g.rate;
  if (!(s > 0)) return 0;
  const double lift = 2 * g.friction.mu_dynamic * g.stiffness / g.mass;
  // Twice integrated from rest at t1: cos(wt) gives (cos(w t1) − cos(w t)) / w² − s sin(w t1) / w.
  const double breathed = (std::cos(w * t1) - std::cos(w * t)) / (w * w) - s * std::sin(w * t1) / w;
  return 0.5 * (lift * g.mean - g.gravity) * s * s + lift * g.swing * breathed;
}

}  // namespace handhold::closed_form
