// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "cases/closed_form/incline.hpp"
#include "cases/closed_form/palm_lift.hpp"
#include "cases/closed_form/stopping.hpp"
#include "tests/cases/closed_form/expected_data.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using testing::integrate;
using testing::integrate_until;
using testing::Point;
using testing::State;

constexpr double rounding = 1e-14;    // relative: a handful of operations
constexpr double integration = 1e-9;  // relative: GSL at 1e-13 a step, some hundred steps, events to the last bit

TEST(Incline, AgreesWithTheCatalogue) {
  for (const auto& e : testing::c01) {
    const Incline incline{.slope = e.th, .friction = {.mu_static = e.mu_s, .mu_dynamic = e.mu_d}};
    EXPECT_EQ(holds(incline), e.hold);
    if (e.hold) continue;
    EXPECT_NEAR(acceleration(incline), e.a, rounding * 10);
    EXPECT_NEAR(time_at(incline, e.D), e.t, rounding * 10);
    EXPECT_NEAR(speed_at(incline, e.D), e.v, rounding * 10);
  }
}

TEST(Incline, AgreesWithIntegrationOfNewtonsLaw) {
  const Incline incline{.slope = 0.7, .friction = {.mu_static = 0.6, .mu_dynamic = 0.3}};
  const auto rates = [](double, const State& y) {  // weight along the slope less kinetic friction of the pressed face
    const double m = 0.2, N = m * 9.81 * std::cos(0.7);
    return State{y[1], (m * 9.81 * std::sin(0.7) - 0.3 * N) / m};
  };
  const Point end = integrate_until(
      rates, {0, {0, 0}}, [](double, const State& y) { return y[0] - 0.25; }, 1);
  EXPECT_NEAR(time_at(incline, 0.25), end.t, integration);
  EXPECT_NEAR(speed_at(incline, 0.25), end.y[1], integration);
  EXPECT_NEAR(slip(incline, end.t), 0.25, integration);
}

TEST(Incline, HoldsForEverBelowItsThreshold) {
  const Incline incline{.slope = std::atan(0.499), .friction = {.mu_static = 0.5, .mu_dynamic = 0.4}};
  EXPECT_EQ(slip(incline, 1e6), 0);
  EXPECT_EQ(time_at(incline, 1e-9), std::numeric_limits<double>::infinity());
}

TEST(Stopping, AgreesWithTheCatalogue) {
  for (const auto& e : testing::c03) {
    const Stopping stopping{.speed = e.v0, .mu_dynamic = e.mu_d, .mass = e.m};
    EXPECT_NEAR(stop_time(stopping), e.t, rounding);
    EXPECT_NEAR(stop_distance(stopping), e.D, rounding);
    EXPECT_NEAR(heat(stopping), e.heat, rounding);
  }
}

TEST(Stopping, SpringsPushBackAsIntegrationSays) {
  const Stopping s{.speed = 0.8, .mu_dynamic = 0.4, .mass = 0.2, .stiffness = 4000, .damping = 4};
  // State x, v, lag of the anchors e = x − anchor; sliding: e = ρ, anchors follow; sticking: anchors stay.
  const double rho = 0.4 * 0.2 * 9.81 / 4000;
  const auto slide = [](double, const State& y) { return State{y[1], -0.4 * 9.81}; };
  const Point stop = integrate_until(
      slide, {0, {0, 0.8}}, [](double, const State& y) { return -y[1]; }, 1);
  const double anchor = stop.y[0] - rho;
  const auto stick = [&](double, const State& y) { return State{y[1], (-4000 * (y[0] - anchor) - 4 * y[1]) / 0.2}; };
  for (const double t : {0.21, 0.25, 0.5}) {
    const Point end = integrate(stick, {stop.t, {stop.y[0], 0}}, t);
    EXPECT_NEAR(distance(s, t), end.y[0], 1e-11) << t;
  }
  EXPECT_NEAR(distance(s, 10), rest_distance(s), 1e-15);
}

TEST(PalmLift, AgreesWithTheCatalogueWhenRigid) {
  for (const auto& e : testing::d13) {
    const PalmLift lift{.amplitude = e.A, .frequency = e.w};
    EXPECT_NEAR(lift_off(lift), e.t1, rounding);
    EXPECT_NEAR(landing(lift), e.t2, 1e-13);  // a cubic touch at lift-off: the root is a little worse than rounding
    EXPECT_NEAR(landing_speed(lift), e.vrel, 1e-12);
  }
}

TEST(PalmLift, AgreesWithIntegrationOnSprings) {
  const PalmLift lift{.amplitude = 0.05, .frequency = 18, .mass = 0.2, .stiffness = 8000};
  const auto hand = [](double t) { return 0.05 * std::sin(18 * t); };
  const double rest = start_depth(lift);
  const auto rates = [&](double t, const State& y) {  // unilateral spring between hand and object
    const double depth = hand(t) - y[0] + rest;
    return State{y[1], -9.81 + std::max(0.0, 8000 * depth) / 0.2};
  };
  const auto gap = [&](double t, const State& y) { return y[0] - rest - hand(t); };
  const Point start{0, {0, start_velocity(lift)}};
  const Point off = integrate_until(rates, start, gap, 0.2);
  EXPECT_NEAR(lift_off(lift), off.t, 1e-10);
  EXPECT_NEAR(height(lift, off.t), off.y[0], 1e-12);
  const auto closing = [&](double t, const State& y) { return t > off.t + 0.05 ? -gap(t, y) : -1; };
  const Point land = integrate_until(rates, off, closing, 0.3);
  EXPECT_NEAR(landing(lift), land.t, 1e-9);
  EXPECT_NEAR(landing_speed(lift), land.y[1] - 0.05 * 18 * std::cos(18 * land.t), 1e-8);
}

TEST(PalmLift, TendsToTheRigidLimitAsTheSoftness) {
  const PalmLift rigid{.amplitude = 0.05, .frequency = 18};
  PalmLift soft = rigid;
  soft.stiffness = 8e4;
  const double shift = lift_off(soft) - lift_off(rigid);
  soft.stiffness = 16e4;
  EXPECT_NEAR((lift_off(soft) - lift_off(rigid)) / shift, 0.5, 1e-3);  // first order in ω²/Ω²
}

TEST(PalmLift, StaysWhenTheHandIsSlow) {
  const PalmLift lift{.amplitude = 0.98 * 9.81 / (18 * 18), .frequency = 18};
  EXPECT_FALSE(leaves(lift));
  EXPECT_TRUE(std::isnan(lift_off(lift)));
}

}  // namespace
}  // namespace handhold::closed_form
