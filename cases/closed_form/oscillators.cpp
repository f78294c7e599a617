// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/oscillators.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace handhold::closed_form {
namespace {

using std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double slip_speed(const HarmonicForce& h, double t) {
  const double w = h.frequency, t1 = slip_onset(h);
  return h.force / (h.mass * w) * (std::cos(w * t1) - std::cos(w * t)) - h.friction.mu_dynamic * h.gravity * (t - t1);
}

double natural(double stiffness, double mass) { return std::sqrt(stiffness / mass); }

// C07: amplitude of the frictionless motion and its friction offset.
double forced(const DenHartog& d) {
  const double r = d.frequency / natural(d.stiffness, d.mass);
  return d.force / d.stiffness / (1 - r * r);
}
double offset(const DenHartog& d) { return d.mu * d.mass * d.gravity / d.stiffness; }
double hartog_u(const DenHartog& d) {
  const double beta = natural(d.stiffness, d.mass) / d.frequency;
  return beta * std::sin(pi * beta) / (1 + std::cos(pi * beta));
}

double kinetic_center(const BeltOscillator& b) { return b.friction.mu_dynamic * b.mass * b.gravity / b.stiffness; }
double half_drop(const BeltOscillator& b) {
  return (b.friction.mu_static - b.friction.mu_dynamic) * b.mass * b.gravity / b.stiffness;
}
double swing(const BeltOscillator& b) { return std::hypot(half_drop(b), b.speed / natural(b.stiffness, b.mass)); }

}  // namespace

bool slips(const HarmonicForce& h) { return h.force > h.friction.mu_static * h.mass * h.gravity; }

double slip_onset(const HarmonicForce& h) {
  return slips(h) ? std::asin(h.friction.mu_static * h.mass * h.gravity / h.force) / h.frequency : nan;
}

double stop_time(const HarmonicForce& h) {
  if (!slips(h)) return nan;
  // The force falls below kinetic friction before half a cycle is over, and the speed is greatest then.
  double a = pi / h.frequency - std::asin(h.friction.mu_dynamic * h.mass * h.gravity / h.force) / h.frequency;
  double b = a + 2 * pi / h.frequency;
  for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b)) (slip_speed(h, m) > 0 ? a : b) = m;
  return b;
}

double slip(const HarmonicForce& h) {
  if (!slips(h)) return 0;
  const double w = h.frequency, t1 = slip_onset(h), t2 = stop_time(h), tau = t2 - t1;
  return h.force / (h.mass * w) * (tau * std::cos(w * t1) - (std::sin(w * t2) - std::sin(w * t1)) / w) -
         h.friction.mu_dynamic * h.gravity * tau * tau / 2;
}

double turning_point(const FrictionOscillator& o, int j) {
  const double size = std::abs(o.start) - 2 * j * o.friction.mu_dynamic * o.mass * o.gravity / o.stiffness;
  return std::copysign(1, o.start) * (j % 2 == 0 ? size : -size);
}

int half_swings(const FrictionOscillator& o) {
  int j = 0;
  while (std::abs(turning_point(o, j)) > o.friction.mu_static * o.mass * o.gravity / o.stiffness) ++j;
  return j;
}

double stop_time(const FrictionOscillator& o) { return half_swings(o) * pi / natural(o.stiffness, o.mass); }

double amplitude(const DenHartog& d) {
  const double A = forced(d), fU = offset(d) * hartog_u(d);
  return std::sqrt(A * A - fU * fU);
}

double phase(const DenHartog& d) { return std::atan2(-offset(d) * hartog_u(d) / forced(d), amplitude(d) / forced(d)); }

// From x = X at rest, moving backwards: x = f + A cos(ωt + φ) + a cos ωn t + b sin ωn t. That it is at −X at rest half
// a cycle later gives a = −f, b = A sin φ ω/ωn.
double position(const DenHartog& d, double t) {
  const double half = pi / d.frequency;
  const double cycles = std::floor(t / half);
  const double tau = t - cycles * half, wn = natural(d.stiffness, d.mass), A = forced(d), f = offset(d);
  const double b = A * std::sin(phase(d)) * d.frequency / wn;
  const double x = f + A * std::cos(d.frequency * tau + phase(d)) - f * std::cos(wn * tau) + b * std::sin(wn * tau);
  return std::fmod(cycles, 2) == 0 ? x : -x;
}

double dissipation(const DenHartog& d) { return 4 * d.mu * d.mass * d.gravity * amplitude(d); }

double restick_position(const BeltOscillator& b) { return kinetic_center(b) - half_drop(b); }

double stick_time(const BeltOscillator& b) { return 2 * half_drop(b) / b.speed; }

double slip_time(const BeltOscillator& b) {
  const double wn = natural(b.stiffness, b.mass);
  return 2 / wn * (pi - std::atan(wn * half_drop(b) / b.speed));
}

double greatest_position(const BeltOscillator& b) { return kinetic_center(b) + swing(b); }

double least_position(const BeltOscillator& b) { return kinetic_center(b) - swing(b); }

double position(const BeltOscillator& b, double t) {
  const double tau = t - stick_time(b), wn = natural(b.stiffness, b.mass);
  if (tau < 0) return restick_position(b) + b.speed * t;
  return kinetic_center(b) + half_drop(b) * std::cos(wn * tau) + b.speed / wn * std::sin(wn * tau);
}

bool sticks(const OscillatingPalm& p) { return p.amplitude * p.frequency * p.frequency <= p.mu * p.gravity; }

bool slides_throughout(const OscillatingPalm& p) {
  return p.amplitude * p.frequency * p.frequency >= p.mu * p.gravity * std::sqrt(1 + pi * pi / 4);
}

double peak_speed(const OscillatingPalm& p) {
  if (sticks(p)) return p.amplitude * p.frequency;
  return slides_throughout(p) ? pi * p.mu * p.gravity / (2 * p.frequency) : nan;
}

double switching_phase(const OscillatingPalm& p) {
  return slides_throughout(p) ? std::acos(peak_speed(p) / (p.amplitude * p.frequency)) : nan;
}

double slip_per_cycle(const OscillatingPalm& p) {
  return sticks(p) ? 0 : 4 * p.amplitude * std::sin(switching_phase(p));
}

}  // namespace handhold::closed_form
