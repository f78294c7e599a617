// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/model/defect.hpp"

namespace handhold::closed_form {
namespace {

double total(const Strike& s) { return s.mass_a + s.mass_b; }
double total(const Stack& s) { return s.mass_lower + s.mass_upper; }

/// How far the palm gets.
double palm(const Stack& s, double t) { return s.jerk * t * t * t / 6; }

}  // namespace

double closing_speed(const Strike& s) { return s.speed_a - s.speed_b; }

double strike_frequency(const Strike& s) { return std::sqrt(s.stiffness * total(s) / (s.mass_a * s.mass_b)); }

double strike_time(const Strike& s) { return s.gap / closing_speed(s); }

double parting_time(const Strike& s) { return strike_time(s) + std::numbers::pi / strike_frequency(s); }

double speed_of_a(const Strike& s, double t) {
  return s.speed_a - s.gravity * t - DEFECT(plastic_strike, 2, 1) * s.mass_b / total(s) * closing_speed(s);
}

/// Over the half period of contact the centre of mass goes on, and a swings about it and back.
double distance_of_a(const Strike& s, double t) {
  const double kick = -2 * s.mass_b / total(s) * closing_speed(s);
  const double in_contact = 0.5 * kick * (parting_time(s) - strike_time(s));
  return s.speed_a * t - 0.5 * s.gravity * t * t + in_contact + kick * (t - parting_time(s));
}

double bounce_frequency(const Bounce& b) { return std::sqrt(b.stiffness / b.mass); }

double landing_speed(const Bounce& b) { return std::sqrt(2 * b.gravity * b.gap); }

double landing_time(const Bounce& b) { return std::sqrt(2 * b.gap / b.gravity); }

double contact_time(const Bounce& b) {
  const double w = bounce_frequency(b);
  return 2 * (std::numbers::pi - std::atan(landing_speed(b) * w / b.gravity)) / w;
}

double flight_time(const Bounce& b) { return DEFECT(flight_up_only, 2, 1) * landing_speed(b) / b.gravity; }

/// d' = S cos(ωt − φ) with S² = v² + (g/ω)², tan φ = g/(ω v).
double squared_speed_in_contact(const Bounce& b) {
  const double w = bounce_frequency(b), v = landing_speed(b), t = contact_time(b);
  const double phase = std::atan2(b.gravity / w, v), squared = v * v + std::pow(b.gravity / w, 2);
  return squared / 2 * (t + (std::sin(2 * (w * t - phase)) + std::sin(2 * phase)) / (2 * w));
}

double lower_start_speed(const Stack& s) { return -total(s) * s.jerk / s.stiffness_palm; }

double upper_start_speed(const Stack& s) { return lower_start_speed(s) - s.mass_upper * s.jerk / s.stiffness_pair; }

double onset(const Stack& s) {
  return std::min(s.mu_palm, DEFECT(stack_slips_below, s.mu_pair, s.mu_palm)) * s.gravity / s.jerk;
}

double upper_slip(const Stack& s, double t) {
  const double begin = onset(s), tau = t - begin, lag = -upper_start_speed(s) * begin;
  const double speed = 0.5 * s.jerk * begin * begin + upper_start_speed(s);
  return palm(s, begin) - lag + speed * tau + 0.5 * s.mu_pair * s.gravity * tau * tau - palm(s, t);
}

double lower_slip(const Stack& s, double t) {
  const double begin = onset(s), tau = t - begin, share = s.mass_upper / total(s);
  const double w = std::sqrt(s.stiffness_pair * total(s) / (s.mass_lower * s.mass_upper));
  const double lag_rate = s.mass_upper * s.jerk / s.stiffness_pair, lag = lag_rate * begin;
  const double center = palm(s, begin) + lower_start_speed(s) * begin - share * lag;
  const double speed = 0.5 * s.jerk * begin * begin + lower_start_speed(s) - share * lag_rate;
  const double swung = lag + lag_rate / w * std::sin(w * tau);
  return center + speed * tau + 0.5 * s.mu_palm * s.gravity * tau * tau + share * swung - palm(s, t);
}

double reach_time(const Sweep& s) { return (s.start - std::acos(s.wall / s.arm)) / s.spin; }

double trailing_angle(const RoundSlide& r) {
  return std::asin(r.mu * r.radius / (r.path_radius * std::sqrt(1 + r.mu * r.mu))) - std::atan(r.mu);
}

double round_depth(const RoundSlide& r) { return r.radius - r.path_radius * std::cos(trailing_angle(r)); }

double round_torque(const RoundSlide& r) {
  return r.stiffness * r.path_radius * std::sin(trailing_angle(r)) * r.radius;
}

}  // namespace handhold::closed_form
