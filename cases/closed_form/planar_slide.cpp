// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/planar_slide.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace handhold::closed_form {
namespace {

using Eigen::Vector2d;

/// Layout of the state: centre (2), velocity (2), angle, spin, then the direction of every leash.
constexpr std::size_t rigid = 6;
using State = std::vector<double>;

Vector2d unit(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// r turned by a quarter: the velocity of a point at r under unit spin.
Vector2d quarter(const Vector2d& r) { return {-r.y(), r.x()}; }

double torque_of(const Vector2d& arm, const Vector2d& force) { return quarter(arm).dot(force); }

struct Motion {
  Vector2d center, velocity;
  double angle, spin;

  explicit Motion(const double y[]) : center(y[0], y[1]), velocity(y[2], y[3]), angle(y[4]), spin(y[5]) {}
  [[nodiscard]] Vector2d material(const Vector2d& point) const { return velocity + spin * quarter(point - center); }
};

Vector2d anchor(const PlanarSlide::Slipping& s, double direction) { return s.p - s.leash * unit(direction); }

int rates(double /*t*/, const double y[], double dydt[], void* parameters) {
  const PlanarSlide& slide = *static_cast<const PlanarSlide*>(parameters);
  const Motion m(y);
  Vector2d force = slide.mass * slide.gravity;
  double torque = 0;
  for (std::size_t i = 0; i < slide.slipping.size(); ++i) {
    const PlanarSlide::Slipping& s = slide.slipping[i];
    const double direction = y[rigid + i];
    const Vector2d C = anchor(s, direction), pull = s.friction * unit(direction);
    force += pull;
    torque += torque_of(C - m.center, pull);
    dydt[rigid + i] = -m.material(C).dot(quarter(unit(direction))) / s.leash;
  }
  const Vector2d first = unit(m.angle), second = quarter(first);
  for (const PlanarSlide::Sticking& s : slide.sticking) {
    const Vector2d arm = s.anchor_B.x() * first + s.anchor_B.y() * second;
    const Vector2d pull = s.stiffness * (s.p - m.center - arm);
    force += pull;
    torque += torque_of(arm, pull);
  }
  dydt[0] = m.velocity.x();
  dydt[1] = m.velocity.y();
  dydt[2] = force.x() / slide.mass;
  dydt[3] = force.y() / slide.mass;
  dydt[4] = m.spin;
  dydt[5] = torque / slide.inertia;
  return GSL_SUCCESS;
}

State start_of(const PlanarSlide& s) {
  State y{s.center.x(), s.center.y(), s.velocity.x(), s.velocity.y(), s.angle, s.spin};
  for (const PlanarSlide::Slipping& sample : s.slipping) y.push_back(sample.direction);
  return y;
}

/// Carries y from `begin` to `end`.
State integrate(const PlanarSlide& slide, State y, double begin, double end, double accuracy) {
  if (!(end > begin)) return y;
  gsl_odeiv2_system system{rates, nullptr, y.size(), const_cast<PlanarSlide*>(&slide)};
  const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-5, accuracy, accuracy), gsl_odeiv2_driver_free);
  double t = begin;
  if (gsl_odeiv2_driver_apply(driver.get(), &t, end, y.data()) != GSL_SUCCESS)
    std::fill(y.begin(), y.end(), std::numeric_limits<double>::quiet_NaN());
  return y;
}

PlanarState public_state(double t, const State& y) {
  const Motion m(y.data());
  return {t, m.center, m.velocity, m.angle, m.spin};
}

/// The least speed of an anchor along its leash.
double slowest_slip(const PlanarSlide& slide, const State& y) {
  const Motion m(y.data());
  double slowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < slide.slipping.size(); ++i) {
    const double direction = y[rigid + i];
    slowest = std::min(slowest, -m.material(anchor(slide.slipping[i], direction)).dot(unit(direction)));
  }
  return slowest;
}

}  // namespace

PlanarState planar_state(const PlanarSlide& slide, double t, double accuracy) {
  return public_state(t, integrate(slide, start_of(slide), 0, t, accuracy));
}

PlanarState first_restick(const PlanarSlide& slide, double longest, double accuracy) {
  constexpr int steps = 1000;
  State y = start_of(slide);
  double a = 0;
  for (int i = 1; i <= steps; ++i) {
    double b = longest * i / steps;
    const State after = integrate(slide, y, a, b, accuracy);
    if (slowest_slip(slide, after) > 0) {
      y = after;
      a = b;
      continue;
    }
    const double begin = a;
    for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b))
      (slowest_slip(slide, integrate(slide, y, begin, m, accuracy)) > 0 ? a : b) = m;
    return public_state(b, integrate(slide, y, begin, b, accuracy));
  }
  return {std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace handhold::closed_form
