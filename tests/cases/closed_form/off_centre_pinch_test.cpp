// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/off_centre_pinch.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using testing::integrate_until;
using testing::Rates;
using testing::State;

constexpr double quarter_turn = std::numbers::pi / 2;
constexpr double tolerance = 1e-9;  // of the integration, whose energy is good to 1e-13 and flat where the swing turns

/// I φ'' = −m g l sin φ + T while φ falls: the equation itself, independent of its solution.
Rates falling(const OffCentrePinch& p) {
  return [p](double, const State& y) {
    return State{y[1], (-p.mass * p.gravity * p.arm * std::sin(y[0]) + p.torque) / p.inertia};
  };
}

/// When the fall from rest at `start` ends, by integration of the equation of motion.
testing::Point fall(const OffCentrePinch& p, double start) {
  const Rates rates = falling(p);
  const testing::Point under_way = testing::integrate(rates, {0, {start, 0}}, 0.01);
  return integrate_until(
      rates, under_way, [](double, const State& y) { return y[1]; }, 1);
}

TEST(OffCentrePinch, HalfPeriodIsThatOfTheEquationOfMotion) {
  const OffCentrePinch pinch;
  EXPECT_NEAR(half_period(pinch, quarter_turn), fall(pinch, quarter_turn).t, tolerance);
  EXPECT_NEAR(half_period(pinch, 2.5), fall(pinch, 2.5).t, tolerance);
}

TEST(OffCentrePinch, HalfPeriodOfASmallSwingIsHarmonic) {
  const OffCentrePinch p;
  // π √(I / (m g l)) (1 + φ²/16): the next term is 11 φ⁴ / 3072 = 4e-11 at 0.01 rad.
  const double harmonic = std::numbers::pi * std::sqrt(p.inertia / (p.mass * p.gravity * p.arm));
  EXPECT_NEAR(half_period(p, 0.01), harmonic * (1 + 1e-4 / 16), 1e-10 * harmonic);
}

TEST(OffCentrePinch, TurnsWhereTheEquationOfMotionDoes) {
  for (const double torque : {0.0, 0.005, 0.02, 0.03, 0.038}) {
    const OffCentrePinch pinch{.torque = torque};
    EXPECT_NEAR(turning_angle(pinch, quarter_turn), fall(pinch, quarter_turn).y[0], tolerance) << torque;
  }
}

TEST(OffCentrePinch, FrictionHoldsWhatWeighsLess) {
  const OffCentrePinch pinch{.torque = 0.2 * 9.81 * 0.02 * 1.001};
  EXPECT_EQ(turning_angle(pinch, quarter_turn), quarter_turn);
}

}  // namespace
}  // namespace handhold::closed_form
