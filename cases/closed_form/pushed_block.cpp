// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/pushed_block.hpp"

#include <algorithm>
#include <cmath>

namespace handhold::closed_form {
namespace {

double up(const Flick& f) { return f.gravity * (std::sin(f.slope) + f.friction.mu_dynamic * std::cos(f.slope)); }
double down(const Flick& f) { return f.gravity * (std::sin(f.slope) - f.friction.mu_dynamic * std::cos(f.slope)); }

}  // namespace

double stop_time(const Flick& f) { return f.speed / up(f); }

double stop_distance(const Flick& f) { return f.speed * f.speed / (2 * up(f)); }

bool returns(const Flick& f) { return std::tan(f.slope) > f.friction.mu_static; }

double return_speed(const Flick& f) { return returns(f) ? f.speed * std::sqrt(down(f) / up(f)) : 0; }

double return_time(const Flick& f) { return returns(f) ? return_speed(f) / down(f) : 0; }

double slip_onset(const LoadRamp& l) { return l.friction.mu_static * l.mass * l.gravity / l.rate; }

double distance(const LoadRamp& l, double t) {
  const double tau = std::max(0.0, t - slip_onset(l));
  const double jump = (l.friction.mu_static - l.friction.mu_dynamic) * l.gravity;
  return tau * tau * (jump / 2 + l.rate * tau / (6 * l.mass));
}

double speed(const LoadRamp& l, double t) {
  const double tau = std::max(0.0, t - slip_onset(l));
  const double jump = (l.friction.mu_static - l.friction.mu_dynamic) * l.gravity;
  return tau * (jump + l.rate * tau / (2 * l.mass));
}

ObliquePoint at_angle(const ObliqueSlide& s, double angle) {
  const double G = s.gravity * std::sin(s.slope), k = s.mu / std::tan(s.slope);
  const double tau0 = std::tan(s.angle / 2), tau = std::tan(angle / 2);
  const double c = s.speed * std::sin(s.angle) / (2 * std::pow(tau0, k));
  // ∫ τ^(n−1) dτ from τ to τ0.
  const auto power = [&](double n) { return (std::pow(tau0, n) - std::pow(tau, n)) / n; };
  return {c / G * (power(k - 1) + power(k + 1)), c * c / G * (power(2 * k - 2) - power(2 * k + 2)),
          2 * c * c / G * (power(2 * k - 1) + power(2 * k + 1)), c * std::pow(tau, k - 1) * (1 + tau * tau)};
}

}  // namespace handhold::closed_form
