// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/rolling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handhold::closed_form {
namespace {

/// ω × z.
Eigen::Vector2d across(const Eigen::Vector3d& spin) { return {spin.y(), -spin.x()}; }

}  // namespace

Eigen::Vector2d sliding_velocity(const SlidingBall& b) { return b.velocity - b.radius * across(b.spin); }

double roll_time(const SlidingBall& b) { return sliding_velocity(b).norm() / (b.mu * b.gravity * (1 + 1 / b.beta)); }

Eigen::Vector2d roll_velocity(const SlidingBall& b) {
  return (b.velocity + b.beta * b.radius * across(b.spin)) / (1 + b.beta);
}

Eigen::Vector2d position(const SlidingBall& b, double t) {
  const double slid = std::min(t, roll_time(b));
  const Eigen::Vector2d direction = sliding_velocity(b).normalized();
  return b.velocity * slid - 0.5 * b.mu * b.gravity * slid * slid * direction + (t - slid) * roll_velocity(b);
}

double heat_per_mass(const SlidingBall& b) { return 0.5 * sliding_velocity(b).squaredNorm() * b.beta / (1 + b.beta); }

double slip_onset(const RolledBall& b) { return 4 * b.mu * b.normal_force / (b.mass * b.jerk * (1 + b.beta)); }

double position(const RolledBall& b, double t) {
  const double rolled = std::min(t, slip_onset(b)), tau = t - rolled;
  const double a = 2 * b.mu * b.normal_force / (b.mass * (1 + b.beta));
  return b.jerk * rolled * rolled * rolled / 12 + b.jerk * rolled * rolled / 4 * tau + a * tau * tau / 2;
}

double slip(const RolledBall& b, double t) { return b.jerk * t * t * t / 6 - 2 * position(b, t); }

double roll_time(const CarriedBall& b) {
  const double scale = b.mass * std::abs(b.upper) / (b.mu * b.normal_force);
  if (b.lower == 0) return scale * (1 + b.beta) / 4;
  if (b.lower == -b.upper) return scale * b.beta / 2;
  if (b.lower == b.upper) return scale / 2;
  return std::numeric_limits<double>::quiet_NaN();
}

double roll_speed(const CarriedBall& b) { return (b.upper + b.lower) / 2; }

double roll_spin(const CarriedBall& b) { return (b.upper - b.lower) / (2 * b.radius); }

// Each slipping contact slides at a speed that falls evenly from |V| to 0: heat μ N |V| t / 2.
double heat(const CarriedBall& b) {
  const int slipping = b.lower == 0 ? 1 : 2;
  return slipping * b.mu * b.normal_force * std::abs(b.upper) * roll_time(b) / 2;
}

bool rolls(const RollDown& b) { return std::tan(b.slope) <= (1 + 1 / b.beta) * b.mu; }

double acceleration(const RollDown& b) {
  if (rolls(b)) return b.gravity * std::sin(b.slope) / (1 + b.beta);
  return b.gravity * (std::sin(b.slope) - b.mu * std::cos(b.slope));
}

double angular_acceleration(const RollDown& b) {
  if (rolls(b)) return acceleration(b) / b.radius;
  return b.mu * b.gravity * std::cos(b.slope) / (b.beta * b.radius);
}

double time_at(const RollDown& b, double distance) { return std::sqrt(2 * distance / acceleration(b)); }

double spin_at(const RollDown& b, double distance) { return angular_acceleration(b) * time_at(b, distance); }

double swing_frequency(const GutterBall& b) { return std::sqrt(b.gravity / ((1 + b.beta) * (b.gutter - b.radius))); }

double needed_friction(const GutterBall& b) { return b.beta / (1 + b.beta) * std::tan(b.start); }

double greatest_speed(const GutterBall& b) {
  return std::sqrt(2 * b.gravity * (b.gutter - b.radius) * (1 - std::cos(b.start)) / (1 + b.beta));
}

}  // namespace handhold::closed_form
