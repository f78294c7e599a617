// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/landing.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/closed_form/pendulum.hpp"
#include "cases/closed_form/rolling.hpp"
#include "tests/cases/closed_form/expected_json.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using testing::expected_sets;
using testing::integrate;
using testing::Point;
using testing::State;

/// Routh: the normal impulse p is the clock; the sliding u loses μ_d (1 + 1/β) a unit of it and then stays at zero.
/// One coefficient, so that stopping within the clock and fitting into the cone are the same.
TEST(Landing, ObeysRouthsIncrementalImpulse) {
  for (const double spin : {-60.0, -10.0, 0.0, 25.0, 200.0}) {
    const Landing l{0.07, 0.6, spin, 0.4, 0.03, 9.81, {0.3, 0.3}};
    const double p_end = landing_speed(l);
    double v = l.velocity, w = l.spin, heat = 9.81 * 0.07;
    const int steps = 100000;
    for (int i = 0; i < steps; ++i) {
      const double dp = p_end / steps, u = v - 0.03 * w, left = std::abs(u) / 3.5;  // 1 + 1/β
      const double j = std::copysign(std::min(0.3 * dp, left), u);
      v -= j;
      w += j / (0.4 * 0.03);
    }
    heat += (0.36 + 0.4 * 0.0009 * spin * spin - v * v - 0.4 * 0.0009 * w * w) / 2;
    EXPECT_NEAR(velocity_after(l), v, 1e-10) << spin;
    EXPECT_NEAR(spin_after(l), w, 1e-8) << spin;
    EXPECT_NEAR(impact_loss_per_mass(l), heat, 1e-9) << spin;
    EXPECT_EQ(grips(l), std::abs(v - 0.03 * w) < 1e-9) << spin;
  }
}

TEST(Landing, OfABlockStopsItOrTakesWhatFrictionCan) {
  const Landing stays{0.05, 0.3, 0, 0, 0, 9.81, {0.5, 0.4}}, slides{0.05, 3, 0, 0, 0, 9.81, {0.5, 0.4}};
  EXPECT_EQ(velocity_after(stays), 0);
  EXPECT_NEAR(impact_loss_per_mass(stays), 9.81 * 0.05 + 0.045, 1e-15);
  EXPECT_NEAR(velocity_after(slides), 3 - 0.4 * std::sqrt(2 * 9.81 * 0.05), 1e-15);
  EXPECT_NEAR(9.81 * landing_time(stays), landing_speed(stays), 1e-15);
}

TEST(GutterBall, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("E07");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const GutterBall b{s.given("R"), s.given("r"), s.given("beta"), s.given("th0"), s.given("g")};
    EXPECT_NEAR(swing_period(swing_frequency(b), b.start), s.number("T"), 1e-12);
    EXPECT_NEAR(greatest_speed(b), s.number("v_max"), 1e-12);
    EXPECT_NEAR(needed_friction(b), s.number("mu_req"), 1e-12);
  }
}

/// Newton and Euler: tangential force f from the spin, normal force from the curvature; the friction needed is largest
/// at the start.
TEST(GutterBall, RollsAsIntegrationSays) {
  const GutterBall b{0.12, 0.03, 0.5, 0.8, 9.81};
  const auto rates = [](double, const State& y) {  // L θ'' = −g sin θ + f/m, and β f/m = … : f/m = −β L θ''
    return State{y[1], -9.81 * std::sin(y[0]) / (1.5 * 0.09)};
  };
  const Point y = integrate(rates, {0, {0.8, 0}}, 0.5);
  EXPECT_NEAR(swing_from_rest(swing_frequency(b), b.start, 0.5), y.y[0], 1e-11);
  const double pull = 0.5 * 9.81 * std::sin(0.8) / 1.5;  // f/m at the start
  EXPECT_NEAR(needed_friction(b), pull / (9.81 * std::cos(0.8)), 1e-15);
}

}  // namespace
}  // namespace handhold::closed_form
