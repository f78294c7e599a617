// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/turning_palm.hpp"

#include <cmath>
#include <numbers>

#include "cases/closed_form/plane_slide.hpp"

namespace handhold::closed_form {
namespace {

/// x = c1 e^(l1 τ) + c2 e^(l2 τ) + P sin Ωt + Q cos Ωt from x0 at rest at the onset.
struct Slide {
  double onset, l1, l2, c1, c2, P, Q;

  explicit Slide(const TiltingPalm& p) : onset(slip_onset(p)) {
    const double W = p.rate, mu = p.friction.mu_dynamic, G = p.gravity / (W * W), root = std::sqrt(1 + mu * mu);
    l1 = W * (mu + root);
    l2 = W * (mu - root);
    P = G * (1 - mu * mu) / (2 * (1 + mu * mu));
    Q = -mu * G / (1 + mu * mu);
    const double s = std::sin(W * onset), c = std::cos(W * onset);
    const double x = p.distance - P * s - Q * c, v = -W * (P * c - Q * s);  // c1 + c2, l1 c1 + l2 c2
    c1 = (v - l2 * x) / (l1 - l2);
    c2 = (l1 * x - v) / (l1 - l2);
  }
};

Eigen::Vector2d quarter(const Eigen::Vector2d& r) { return {-r.y(), r.x()}; }

Eigen::Vector2d turned(const Eigen::Vector2d& r, double angle) {
  return std::cos(angle) * r + std::sin(angle) * quarter(r);
}

double precession(const TurntableBall& b) { return b.beta / (1 + b.beta) * b.rate; }

}  // namespace

double onset_angle(const TiltingPalm& p) {
  const double phi = std::atan(p.friction.mu_static);
  return phi + std::asin(p.distance * p.rate * p.rate * std::cos(phi) / p.gravity);
}

double slip_onset(const TiltingPalm& p) { return onset_angle(p) / p.rate; }

double place(const TiltingPalm& p, double t) {
  const Slide s(p);
  if (t <= s.onset) return p.distance;
  const double tau = t - s.onset;
  return s.c1 * std::exp(s.l1 * tau) + s.c2 * std::exp(s.l2 * tau) + s.P * std::sin(p.rate * t) +
         s.Q * std::cos(p.rate * t);
}

double speed(const TiltingPalm& p, double t) {
  const Slide s(p);
  if (t <= s.onset) return 0;
  const double tau = t - s.onset;
  return s.l1 * s.c1 * std::exp(s.l1 * tau) + s.l2 * s.c2 * std::exp(s.l2 * tau) +
         p.rate * (s.P * std::cos(p.rate * t) - s.Q * std::sin(p.rate * t));
}

double normal_acceleration(const TiltingPalm& p, double t) {
  return p.gravity * std::cos(p.rate * t) + 2 * p.rate * speed(p, t);
}

double slip_onset(const SpunPalm& p) {
  const double ratio = p.mu_static * p.gravity / (p.radius * p.acceleration);
  return std::pow((ratio * ratio - 1) / (p.acceleration * p.acceleration), 0.25);
}

double slip_direction(const SpunPalm& p) {
  const double w = p.acceleration * slip_onset(p);
  return std::atan2(-p.acceleration, w * w);
}

SpunPlace slide(const SpunPalm& p, double mu_dynamic, double t) {
  const double alpha = p.acceleration, begin = slip_onset(p), start = slip_direction(p);
  const Eigen::Vector2d from(p.radius, 0);
  const auto drive = [&](double s, const Eigen::Vector2d& x, const Eigen::Vector2d& u) -> Eigen::Vector2d {
    const double w = alpha * s;
    return w * w * (from + x) - alpha * quarter(from + x) - 2 * w * quarter(u);
  };
  const PlaneSlide slid =
      slide_from_rest(drive, mu_dynamic * p.gravity, begin, Eigen::Vector2d(std::cos(start), std::sin(start)), t);
  const double angle = alpha * t * t / 2;
  const Eigen::Vector2d place = from + slid.x;
  return {turned(place, angle), turned(slid.u + alpha * t * quarter(place), angle)};
}

double period(const TurntableBall& b) { return 2 * std::numbers::pi / precession(b); }

Eigen::Vector2d position(const TurntableBall& b, double t) {
  const double k = precession(b), angle = k * t;
  return b.place + (std::sin(angle) * b.velocity + (1 - std::cos(angle)) * quarter(b.velocity)) / k;
}

Eigen::Vector2d velocity(const TurntableBall& b, double t) { return turned(b.velocity, precession(b) * t); }

Eigen::Vector2d spin(const TurntableBall& b, double t) {
  return quarter(velocity(b, t) - b.rate * quarter(position(b, t))) / b.radius;
}

}  // namespace handhold::closed_form
