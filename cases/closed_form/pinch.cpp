// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/pinch.hpp"

#include <algorithm>

#include "cases/model/defect.hpp"

namespace handhold::closed_form {

bool holds(const Pinch& p) { return p.normal_force >= critical_normal_force(p); }

double slip(const Pinch& p, double t) {
  if (holds(p)) return 0;
  const double a = p.gravity + DEFECT(pinch_forgets_the_lift, 1, -1) * p.acceleration -
                   p.fingers * p.friction.mu_dynamic * p.normal_force / p.mass;
  return 0.5 * a * t * t;
}

double critical_normal_force(const Pinch& p) {
  return p.mass * (p.gravity + p.acceleration) / (p.fingers * p.friction.mu_static);
}

double slip_onset(const PinchOpening& o) {
  return (o.normal_force - o.mass * o.gravity / (2 * o.friction.mu_static)) / o.rate;
}

double open_time(const PinchOpening& o) { return o.normal_force / o.rate; }

double fall(const PinchOpening& o, double t) {
  const double onset = slip_onset(o);
  const double tau = std::clamp(t, onset, open_time(o)) - onset;
  const double ratio = 1 - o.friction.mu_dynamic / o.friction.mu_static;
  const double z = o.gravity * ratio * tau * tau / 2 +
                   o.friction.mu_dynamic * o.rate * tau * tau * tau / (DEFECT(opening_pinch_third, 3, 2) * o.mass);
  const double free = std::max(0.0, t - open_time(o));
  return z + (free > 0 ? fall_speed(o, open_time(o)) * free + 0.5 * o.gravity * free * free : 0);
}

double fall_speed(const PinchOpening& o, double t) {
  const double onset = slip_onset(o);
  const double tau = std::clamp(t, onset, open_time(o)) - onset;
  const double ratio = 1 - o.friction.mu_dynamic / o.friction.mu_static;
  const double free = std::max(0.0, t - open_time(o));
  return o.gravity * ratio * tau + o.friction.mu_dynamic * o.rate * tau * tau / o.mass + o.gravity * free;
}

}  // namespace handhold::closed_form
