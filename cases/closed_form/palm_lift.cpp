// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/palm_lift.hpp"

#include <cmath>
#include <limits>

namespace handhold::closed_form {
namespace {

/// ω²/Ω², the compliance seen at the hand's frequency; 0 when rigid.
double softness(const PalmLift& l) { return l.stiffness > 0 ? l.frequency * l.frequency * l.mass / l.stiffness : 0; }

double hand(const PalmLift& l, double t) { return l.amplitude * std::sin(l.frequency * t); }

/// Velocity of the object while it stands on the hand: A ω cos ωt Ω²/(Ω² − ω²).
double carried_velocity(const PalmLift& l, double t) {
  return l.amplitude * l.frequency * std::cos(l.frequency * t) / (1 - softness(l));
}

double flight(const PalmLift& l, double t1, double t) {
  const double tau = t - t1;
  return hand(l, t1) + carried_velocity(l, t1) * tau - 0.5 * l.gravity * tau * tau;
}

}  // namespace

bool leaves(const PalmLift& l) { return l.amplitude * l.frequency * l.frequency > l.gravity * (1 - softness(l)); }

double lift_off(const PalmLift& l) {
  if (!leaves(l)) return std::numeric_limits<double>::quiet_NaN();
  const double sine = l.gravity * (1 - softness(l)) / (l.amplitude * l.frequency * l.frequency);
  return std::asin(sine) / l.frequency;
}

double landing(const PalmLift& l) {
  const double t1 = lift_off(l);
  if (!(t1 >= 0)) return t1;
  const auto gap = [&](double t) { return flight(l, t1, t) - hand(l, t); };
  // The gap opens as (t − t1)³; step until it closes, then bisect: no method needs more, and none may miss the first
  // root.
  const double step = 1e-3 / l.frequency;
  double a = t1 + 10 * step;
  while (gap(a + step) > 0) a += step;
  double b = a + step;
  for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b)) (gap(m) > 0 ? a : b) = m;
  return b;
}

double landing_speed(const PalmLift& l) {
  const double t1 = lift_off(l);
  const double t2 = landing(l);
  const double object = carried_velocity(l, t1) - l.gravity * (t2 - t1);
  return object - l.amplitude * l.frequency * std::cos(l.frequency * t2);
}

double height(const PalmLift& l, double t) {
  const double t1 = lift_off(l);
  if (t >= t1) return start_depth(l) + flight(l, t1, t);
  // y = h − δ, δ = g/Ω² − A ω² sin ωt/(Ω² − ω²), counted from −g/Ω² at t = 0.
  return hand(l, t) / (1 - softness(l));
}

double start_depth(const PalmLift& l) { return l.stiffness > 0 ? l.gravity * l.mass / l.stiffness : 0; }

double start_velocity(const PalmLift& l) { return carried_velocity(l, 0); }

}  // namespace handhold::closed_form
