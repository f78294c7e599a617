#include "cases/closed_form/rigid_shake.hpp"

#include <cmath>
#include <numbers>

namespace handhold::closed_form {
namespace {

/// Upward acceleration that friction can give, less gravity.
double spare(const RigidShake& s) { return 2 * s.mu * s.normal_force / s.mass - s.gravity; }

/// Of the object, upwards, against the hand: negative while it slides down.
double slip_speed(const RigidShake& s, double t) {
  const double w = s.frequency, t1 = onset_time(s);
  return spare(s) * (t - t1) - s.amplitude * w * (std::cos(w * t) - std::cos(w * t1));
}

}  // namespace

double onset_time(const RigidShake& s) {
  const double w = s.frequency;
  return (std::numbers::pi + std::asin(spare(s) / (s.amplitude * w * w))) / w;
}

double stop_time(const RigidShake& s) {
  // From the moment of the fastest slip, when the hand's acceleration is at the threshold again, to a period after.
  const double t1 = onset_time(s), w = s.frequency;
  double sliding = 3 * std::numbers::pi / w - t1, stopped = t1 + 2 * std::numbers::pi / w;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.5 * (sliding + stopped);
    (slip_speed(s, t) < 0 ? sliding : stopped) = t;
  }
  return stopped;
}

double slip_per_period(const RigidShake& s) {
  const double t1 = onset_time(s), t2 = stop_time(s), w = s.frequency, time = t2 - t1;
  const double waved = s.amplitude * (std::sin(w * t2) - std::sin(w * t1));
  return waved - s.amplitude * w * std::cos(w * t1) * time - 0.5 * spare(s) * time * time;
}

}  // namespace handhold::closed_form
