// SPDX-License-Identifier: GPL-3.0-or-later
// Rings of samples: pursuit, twisted ring (G08), spin stop (G09), limit load (F02). Figures "of the catalogue" were
// computed by another program and are copied with their id.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gsl/gsl_sf_ellint.h>
#include <gtest/gtest.h>

#include "cases/closed_form/pursuit.hpp"
#include "cases/closed_form/ring_limit.hpp"
#include "cases/closed_form/spin_stop.hpp"
#include "cases/closed_form/twisted_ring.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using testing::integrate;
using testing::integrate_until;
using testing::Point;
using testing::State;

constexpr double pi = std::numbers::pi;

TEST(Pursuit, SolvesItsEquation) {
  // Ratios below, at and above 1: three branches of the solution. Only ψ of less than a quarter turn is ever asked for.
  for (const double q : {0.6, 1.0, 1.5, 32.0}) {
    const auto rates = [q](double, const State& y) { return State{1 - q * std::sin(y[0])}; };
    const double start = std::asin(0.4 / std::max(1.0, q));
    for (const double turn : {1e-9, 0.05, 0.4}) {
      const Point end = integrate(rates, {0, {start}}, turn);
      EXPECT_NEAR(pursuit_angle(q, start, turn), end.y[0], 1e-12) << q << " " << turn;
    }
  }
}

TEST(Pursuit, TurnAndWorkInvertIt) {
  const double q = 20, start = 0.01, turn = 0.08;
  const double end = pursuit_angle(q, start, turn);
  EXPECT_NEAR(pursuit_turn(q, start, end), turn, 1e-13);
  // Work by integration beside the angle.
  const auto rates = [q](double, const State& y) { return State{1 - q * std::sin(y[0]), std::cos(y[0])}; };
  const Point there = integrate(rates, {0, {start, 0}}, turn);
  EXPECT_NEAR(pursuit_after_work(q, start, there.y[1]), end, 1e-12);
}

TEST(TwistedRing, AgreesWithTheCatalogueForSmallAngles) {
  const TwistedRing ring;  // G08, set 0
  EXPECT_NEAR(linear_torque(ring, 0.35), 0.0043416778993702505, 1e-16);
  // Small lags (stiff springs) turn by small angles: the exact torque tends to the linear one as the square of them.
  TwistedRing stiff = ring;
  stiff.stiffness = 1e4;
  EXPECT_NEAR(first_slip_angle(stiff), 0.17857142857142858 / 100, 1e-9);
  EXPECT_NEAR(last_slip_angle(stiff), 1.25 / 100, 1e-7);
  const double angle = 0.35 / 100, linear = linear_torque(stiff, angle);
  const double error = torque(stiff, angle) / linear - 1;
  stiff.stiffness = 2e4;
  const double half = torque(stiff, angle / 2) / linear_torque(stiff, angle / 2) - 1;
  EXPECT_LT(std::abs(error), 1e-5);
  EXPECT_NEAR(half / error, 0.25, 0.01);
}

/// Torque of one sample by return mapping in the plane, 1e-6 rad a step: stick, or leash of constant length.
double mapped_torque(const TwistedRing& r, double place, double angle, int steps) {
  const double mu_N = r.friction.mu_dynamic * r.normal_force / r.samples, leash = mu_N / r.stiffness;
  const double px = r.radius * std::cos(place) - r.offset, py = r.radius * std::sin(place);
  double cx = px, cy = py, ex = 0, ey = 0;
  for (int i = 1; i <= steps; ++i) {
    const double c = std::cos(angle * i / steps), s = std::sin(angle * i / steps);
    ex = c * px - s * py - cx;
    ey = s * px + c * py - cy;
    const double length = std::hypot(ex, ey);
    if (length <= leash) continue;
    cx += ex * (1 - leash / length);
    cy += ey * (1 - leash / length);
    ex *= leash / length;
    ey *= leash / length;
  }
  return r.stiffness * (cx * ey - cy * ex);
}

TEST(TwistedRing, AgreesWithReturnMappingAtFiniteAngles) {
  for (const double offset : {0.0, 0.003}) {
    const TwistedRing ring{.offset = offset};
    double sum = 0;
    for (int i = 0; i < ring.samples; ++i) sum += mapped_torque(ring, 2 * pi * i / ring.samples, 0.35, 400000);
    EXPECT_NEAR(torque(ring, 0.35) / sum, 1, 1e-6);  // first order of 1e-6 rad a step
  }
  EXPECT_EQ(slipping({}, 0.35), 5);
  EXPECT_EQ(slipping({}, 0.17), 0);
}

/// The whole of G09 by integration of what happens: one anchor in the object's frame (all are alike), spin and angle.
struct Stopped {
  Point breakaway, stop;
  double radius, behind;  // of the anchor: distance from the axis, angle behind its sample
};

Stopped integrate_stop(const SpinStop& s) {
  const double each = s.stiffness / 8, full = 16 * each;
  const auto sample = [&](double angle) {  // the hand turns back in the object's frame
    return std::pair{s.radius * std::cos(angle), -s.radius * std::sin(angle)};
  };
  const double limit = s.friction.mu_static * s.normal_force / s.stiffness;
  const double leash = s.friction.mu_dynamic * s.normal_force / s.stiffness;
  const auto stick = [&](double, const State& y) {
    const auto [px, py] = sample(y[0]);
    return State{y[1], full * s.radius * py / s.inertia};  // anchor at (a, 0): torque a × k (p − C)
  };
  const auto outside = [&](double, const State& y) {
    const auto [px, py] = sample(y[0]);
    return std::hypot(px - s.radius, py) - limit;
  };
  const Point breakaway = integrate_until(stick, {0, {0, s.spin}}, outside, 0.05);
  const auto [px, py] = sample(breakaway.y[0]);
  const double direction = std::atan2(py, px - s.radius);
  const auto slip = [&](double, const State& y) {
    const auto [qx, qy] = sample(y[0]);
    const double vx = y[1] * qy, vy = -y[1] * qx;
    const double ex = std::cos(y[2]), ey = std::sin(y[2]);
    const double cx = qx - leash * ex, cy = qy - leash * ey;
    return State{y[1], full * leash * (cx * ey - cy * ex) / s.inertia, (ex * vy - ey * vx) / leash};
  };
  const Point stop = integrate_until(
      slip, {breakaway.t, {breakaway.y[0], breakaway.y[1], direction}}, [](double, const State& y) { return -y[1]; },
      0.2);
  const auto [ax, ay] = sample(stop.y[0]);
  const double cx = ax - leash * std::cos(stop.y[2]), cy = ay - leash * std::sin(stop.y[2]);
  return {breakaway, stop, std::hypot(cx, cy), std::atan2(ax * cy - ay * cx, ax * cx + ay * cy)};
}

TEST(SpinStop, AgreesWithIntegration) {
  for (const SpinStop& s :
       {SpinStop{.friction = {.mu_static = 0.5, .mu_dynamic = 0.4}},
        SpinStop{.stiffness = 1600, .spin = 4, .friction = {.mu_static = 0.5, .mu_dynamic = 0.5}}}) {
    const Stopped truth = integrate_stop(s);
    EXPECT_NEAR(breakaway_time(s), truth.breakaway.t, 1e-12);
    EXPECT_NEAR(breakaway_angle(s), truth.breakaway.y[0], 1e-11);
    EXPECT_NEAR(breakaway_spin(s), truth.breakaway.y[1], 1e-10);
    EXPECT_NEAR(restick_time(s), truth.stop.t, 1e-10);
    EXPECT_NEAR(restick_angle(s), truth.stop.y[0], 1e-10);
    EXPECT_NEAR(residual_amplitude(s), truth.behind, 1e-9);
    EXPECT_NEAR(residual_frequency(s), std::sqrt(2 * s.stiffness * s.radius * truth.radius / s.inertia), 1e-7);
  }
}

TEST(SpinStop, TendsToTheCatalogueForSmallAngles) {
  const SpinStop s{.inertia = 1e-4, .stiffness = 16000, .spin = 0.5, .friction = {0.5, 0.5}};  // G09, set 1
  EXPECT_GT(critical_spin(s), s.spin);
  EXPECT_NEAR(s.spin / torsional_frequency(s), 0.006987712429686843, 1e-16);
  const double quarter = pi / 2 / torsional_frequency(s);
  EXPECT_NEAR(angle(s, quarter), 0.006987712429686843, 1e-7);  // the pendulum's own: amplitude³ / 24
}

TEST(LimitLoad, OfManySamplesIsTheCatalogues) {
  struct Set {
    double radius, arm, weight, center;
  };
  for (const Set& e : {Set{0.004, 0.02, 0.7705854008904524, 0.0015125671958061346},
                       Set{0.004, 0.006, 2.0264286518676733, 0.0035261757787485833},
                       Set{0.008, 0.1, 0.3179809571058002, 0.0012679048512924227}}) {
    const LimitLoad l = limit_load({.radius = e.radius, .arm = e.arm, .samples = 4096});
    EXPECT_NEAR(l.weight, e.weight, 1e-13);
    EXPECT_NEAR(l.center, e.center, 1e-12);
    // Upper bound by the elliptic integral of the continuous ring.
    const double m = 4 * e.radius * l.center / std::pow(e.radius + l.center, 2);
    const double mean = 2 * (e.radius + l.center) * gsl_sf_ellint_Ecomp(std::sqrt(m), GSL_PREC_DOUBLE) / pi;
    EXPECT_NEAR(2 * 0.5 * 4 * mean / (e.arm + l.center), e.weight, 1e-13);
  }
}

// Static theorem: forces of full size across the lines to the centre of rotation are in balance with the weight, so
// that it is also a lower bound.
TEST(LimitLoad, OfEightSamplesIsInBalance) {
  const EccentricLoad load{.arm = 0.02};
  const LimitLoad limit = limit_load(load);
  double up = 0, across = 0, torque = 0;
  for (int i = 0; i < 8; ++i) {
    const double x = load.radius * std::cos(2 * pi * i / 8), z = load.radius * std::sin(2 * pi * i / 8);
    const double dx = x + limit.center, size = 2 * load.mu * load.normal_force / 8 / std::hypot(dx, z);
    up += size * dx;
    across -= size * z;
    torque += x * size * dx + z * size * z;
  }
  EXPECT_NEAR(up, limit.weight, 1e-12);
  EXPECT_NEAR(across, 0, 1e-14);
  EXPECT_NEAR(torque, limit.weight * load.arm, 1e-14);
}

}  // namespace
}  // namespace handhold::closed_form
