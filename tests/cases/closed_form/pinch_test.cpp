// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/pinch.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/closed_form/spin_down.hpp"
#include "tests/cases/closed_form/expected_data.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using testing::integrate;
using testing::integrate_until;
using testing::Point;
using testing::State;

TEST(Pinch, AgreesWithTheCatalogue) {
  for (const auto& e : testing::d01) {
    const Pinch pinch{.fingers = e.n,
                      .normal_force = e.N,
                      .mass = e.m,
                      .acceleration = e.a,
                      .friction = {.mu_static = e.mu_s, .mu_dynamic = e.mu_d}};
    const bool at_threshold =
        std::abs(e.N / critical_normal_force(pinch) - 1) < 1e-12;  // set 3: rounding decides there
    if (!at_threshold) {
      EXPECT_EQ(holds(pinch), e.hold);
    }
    EXPECT_NEAR(slip(pinch, e.T), e.slip, 1e-15);
  }
}

TEST(Pinch, SlipsAsIntegrationOfObjectAndHandSays) {
  const Pinch pinch{.fingers = 3,
                    .normal_force = 1,
                    .mass = 0.3,
                    .acceleration = 2,
                    .friction = {.mu_static = 0.5, .mu_dynamic = 0.3}};
  const auto rates = [](double, const State& y) { return State{y[1], -9.81 + 3 * 0.3 * 1 / 0.3, y[3], 2}; };
  const Point end = integrate(rates, {0, {0, 0, 0, 0}}, 0.2);
  EXPECT_NEAR(slip(pinch, 0.2), end.y[2] - end.y[0], 1e-12);
}

TEST(PinchOpening, AgreesWithTheCatalogue) {
  for (const auto& e : testing::d02) {
    const PinchOpening o{
        .mass = e.m, .normal_force = e.N0, .rate = e.r, .friction = {.mu_static = e.mu_s, .mu_dynamic = e.mu_d}};
    EXPECT_NEAR(slip_onset(o), e.t_s, 1e-14 * e.t_s);
    EXPECT_NEAR(open_time(o), e.t_open, 1e-14 * e.t_open);
    EXPECT_NEAR(fall(o, open_time(o)), e.z_open, 1e-14 * e.z_open);
    EXPECT_NEAR(fall_speed(o, open_time(o)), e.v_open, 1e-14 * e.v_open);
    EXPECT_NEAR(fall(o, open_time(o) + 0.1), e.z_after, 1e-14 * e.z_after);
  }
}

TEST(PinchOpening, FallsAsIntegrationSays) {
  const PinchOpening o{.mass = 0.08, .normal_force = 2, .rate = 6, .friction = {.mu_static = 0.7, .mu_dynamic = 0.5}};
  const auto N = [](double t) { return std::max(0.0, 2 - 6 * t); };
  // While it sticks, friction balances the weight; it slips once 2 mu_s N cannot.
  const auto stuck = [](double, const State&) { return State{0, 0}; };
  const auto overload = [&](double t, const State&) { return 0.08 * 9.81 - 2 * 0.7 * N(t); };
  const Point onset = integrate_until(stuck, {0, {0, 0}}, overload, 0.5);
  EXPECT_NEAR(slip_onset(o), onset.t, 1e-12);
  const auto falling = [&](double t, const State& y) { return State{y[1], 9.81 - 2 * 0.5 * N(t) / 0.08}; };
  for (const double t : {0.28, 1.0 / 3, 0.4}) {
    const Point end = integrate(falling, onset, t);
    EXPECT_NEAR(fall(o, t), end.y[0], 1e-11) << t;
    EXPECT_NEAR(fall_speed(o, t), end.y[1], 1e-10) << t;
  }
}

TEST(SpinDown, AgreesWithTheCatalogueForAllThreePatches) {
  constexpr PatchShape shapes[] = {PatchShape::ring, PatchShape::disc, PatchShape::hertz};
  for (const auto& e : testing::f01) {
    const SpinDown spin{.inertia = e.I, .normal_force = e.N, .mu = e.mu, .radius = e.a, .spin = e.w0};
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(stop_time(spin, shapes[i]), e.t[i], 1e-14);
      EXPECT_NEAR(stop_angle(spin, shapes[i]), e.angle[i], 1e-14 * e.angle[i]);
    }
  }
}

/// Torque of a pressure p(r) = share(r) N / (π a²) sliding in rotation, by midpoint quadrature in r²: ∫ μ p r dA.
double torque_of_pressure(double N, double mu, double a, double (*share)(double)) {
  const int n = 200000;
  double torque = 0;
  for (int i = 0; i < n; ++i) {
    const double s = (i + 0.5) / n;  // r²/a²; dA = π a² ds
    torque += 2 * mu * N * share(s) * a * std::sqrt(s) / n;
  }
  return torque;
}

TEST(SpinDown, TorqueOfDiscAndHertzAreTheIntegralsOfTheirPressure) {
  const SpinDown spin{.normal_force = 3, .mu = 0.4, .radius = 0.005};
  const double disc = torque_of_pressure(3, 0.4, 0.005, [](double) { return 1.0; });
  const double hertz = torque_of_pressure(3, 0.4, 0.005, [](double s) { return 1.5 * std::sqrt(1 - s); });
  EXPECT_NEAR(torque(spin, PatchShape::disc), disc, 1e-7 * disc);  // quadrature error of √s at 0: n^(−3/2)
  EXPECT_NEAR(torque(spin, PatchShape::hertz), hertz, 1e-7 * hertz);
}

/// The L2 ring: one sample of each of the two patches, integrated as what it is, a trailing anchor; nothing assumed of
/// its curve.
TEST(SpinDown, AnchorsTrailOnThePursuitCurve) {
  const SpinDown spin{.inertia = 1e-4, .normal_force = 2, .mu = 0.5, .radius = 0.004, .spin = 20, .stiffness = 2000};
  const double rho = lag(spin);
  // State: spin angle, spin, direction θ of the lag in the object's frame. The sample turns backwards in that frame.
  const auto sample = [](const State& y) { return std::pair{0.004 * std::cos(y[0]), -0.004 * std::sin(y[0])}; };
  const auto rates = [&](double, const State& y) {
    const auto [px, py] = sample(y);
    const double vx = y[1] * py, vy = -y[1] * px;  // of the sample against the object
    const double ex = std::cos(y[2]), ey = std::sin(y[2]);
    const double fx = 0.5 * 2 * ex, fy = 0.5 * 2 * ey;  // mu N along the lag, on the object at the anchor
    const double cx = px - rho * ex, cy = py - rho * ey;
    const double turn = (ex * vy - ey * vx) / rho;  // rigid trailer: the anchor moves along the lag only
    return State{y[1], 2 * (cx * fy - cy * fx) / 1e-4, turn};
  };
  const double psi = std::asin(rho / 0.004);
  const State start{0, 20, psi - std::acos(-1.0) / 2};  // tangent to the anchor's circle
  const Point stop = integrate_until(
      rates, {0, start}, [](double, const State& y) { return -y[1]; }, 0.5);
  EXPECT_NEAR(stop_time(spin, PatchShape::ring), stop.t, 1e-10);
  EXPECT_NEAR(stop_angle(spin, PatchShape::ring), stop.y[0], 1e-9);
  const Point mid = integrate(rates, {0, start}, 0.1);
  EXPECT_NEAR(angle(spin, PatchShape::ring, 0.1), mid.y[0], 1e-10);
}

}  // namespace
}  // namespace handhold::closed_form
