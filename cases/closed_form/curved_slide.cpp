// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/curved_slide.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "cases/closed_form/quadrature.hpp"

namespace handhold::closed_form {
namespace {

using std::numbers::pi;

/// Zero of f, which is positive at a and not at b, to the last bit.
double fall(const std::function<double(double)>& f, double a, double b) {
  for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b)) (f(m) > 0 ? a : b) = m;
  return b;
}

/// c (P cos x + Q sin x) at `base` and `base + delta`: the second less the first times e^(k delta), without
/// cancellation when delta is small.
double change(double P, double Q, double k, double base, double delta) {
  const double middle = base + delta / 2, half = 2 * std::sin(delta / 2);
  const double particular = P * std::cos(base) + Q * std::sin(base);
  return half * (Q * std::cos(middle) - P * std::sin(middle)) - particular * std::expm1(k * delta);
}

/// v² of a swing with v = 0 at a0, at a0 + delta.
double swing(const Bowl& b, double a0, double delta) {
  const double mu = b.friction.mu_dynamic, scale = b.gravity * b.radius / (1 + 4 * mu * mu);
  return change(2 * scale * (1 - 2 * mu * mu), -6 * scale * mu, -2 * mu, a0, delta);
}

/// v² on a dome at start_angle + delta.
double descent(const Dome& d, double delta) {
  const double mu = d.mu, scale = d.gravity * d.radius / (1 + 4 * mu * mu);
  return change(2 * scale * (2 * mu * mu - 1), -6 * scale * mu, 2 * mu, d.start_angle, delta) +
         d.start_speed * d.start_speed * std::exp(2 * mu * delta);
}

double next_stop(const Bowl& b, double a0) {
  const double step = 1e-3;
  const auto w = [&](double delta) { return swing(b, a0, delta); };
  double delta = step;
  if (w(delta) <= 0) return a0 + fall(w, 1e-9, delta);
  while (w(delta + step) > 0) delta += step;
  return a0 + fall(w, delta, delta + step);
}

}  // namespace

double speed_squared(const Dome& d, double angle) { return descent(d, angle - d.start_angle); }

double lift_off_angle(const Dome& d) {
  const auto pressed = [&](double x) { return d.gravity * d.radius * std::cos(x) - speed_squared(d, x); };
  const double step = 1e-3;
  double a = d.start_angle;
  while (pressed(a + step) > 0) {
    a += step;
    if (speed_squared(d, a) <= 0) return std::numeric_limits<double>::quiet_NaN();
  }
  return fall(pressed, a, a + step);
}

double lift_off_speed(const Dome& d) { return std::sqrt(speed_squared(d, lift_off_angle(d))); }

// θ = θ0 + s² takes away the square-root singularity of a start at rest.
double lift_off_time(const Dome& d) {
  const auto rate = [&](double s) { return 2 * s * d.radius / std::sqrt(descent(d, s * s)); };
  return gauss_legendre(rate, 0, std::sqrt(lift_off_angle(d) - d.start_angle));
}

std::vector<double> turning_angles(const Bowl& b) {
  std::vector<double> angles{b.start_angle};
  while (std::tan(std::abs(angles.back())) > b.friction.mu_static) {
    const double side = angles.back() > 0 ? -1 : 1;
    angles.push_back(side * next_stop(b, side * angles.back()));
  }
  return angles;
}

// a = middle − half cos ψ takes away the singularities at both ends; each half counts from its own end.
std::vector<double> turning_times(const Bowl& b) {
  const std::vector<double> angles = turning_angles(b);
  std::vector<double> times{0};
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double side = angles[i - 1] > 0 ? -1 : 1, a0 = side * angles[i - 1], a1 = side * angles[i];
    const auto rate = [&](double end, double sign) {
      return [&b, a0, a1, end, sign](double psi) {
        const double from_end = (a1 - a0) * std::pow(std::sin(psi / 2), 2);
        return b.radius * 0.5 * (a1 - a0) * std::sin(psi) / std::sqrt(swing(b, end, sign * from_end));
      };
    };
    const double time = gauss_legendre(rate(a0, 1), 0, pi / 2) + gauss_legendre(rate(a1, -1), 0, pi / 2);
    times.push_back(times.back() + time);
  }
  return times;
}

double stop_time(const WallSlide& w) {
  const double a = w.mu_floor * w.gravity, b = w.mu_wall / w.radius;
  return std::atan(w.speed * std::sqrt(b / a)) / std::sqrt(a * b);
}

double swept_angle(const WallSlide& w) {
  return std::log1p(w.mu_wall * w.speed * w.speed / (w.mu_floor * w.gravity * w.radius)) / (2 * w.mu_wall);
}

double speed_at(const WallSlide& w, double t) {
  const double a = w.mu_floor * w.gravity, b = w.mu_wall / w.radius;
  return std::sqrt(a / b) * std::tan(std::sqrt(a * b) * std::max(0.0, stop_time(w) - t));
}

// ∫ tan: (1/b) ln(cos(remaining) / cos(at the start)) of way.
double angle_at(const WallSlide& w, double t) {
  const double a = w.mu_floor * w.gravity, b = w.mu_wall / w.radius, rate = std::sqrt(a * b);
  const double left = std::max(0.0, stop_time(w) - t);
  return std::log(std::cos(rate * left) / std::cos(rate * stop_time(w))) / (b * w.radius);
}

}  // namespace handhold::closed_form
