// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/oscillators.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/cases/closed_form/expected_json.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using std::numbers::pi;
using testing::expected_sets;
using testing::integrate;
using testing::integrate_until;
using testing::Point;
using testing::State;

constexpr double catalogue = 1e-12;   // relative: roots and square roots, by two programs
constexpr double integration = 1e-9;  // GSL at 1e-13 a step, some hundred steps, events to the last bit

HarmonicForce harmonic_force(const testing::ExpectedSet& s) {
  return {s.given("m"), s.given("F0"), s.given("w"), s.given("g"), {s.given("mu_s"), s.given("mu_d")}};
}

TEST(HarmonicForce, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C05");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const HarmonicForce h = harmonic_force(s);
    EXPECT_NEAR(slip_onset(h), s.number("t1"), catalogue);
    EXPECT_NEAR(stop_time(h), s.number("t2"), catalogue);
    EXPECT_NEAR(slip(h), s.number("slip"), catalogue);
  }
}

TEST(HarmonicForce, SlipsAsIntegrationSays) {
  const HarmonicForce h{.mass = 0.3, .force = 2.2, .frequency = 7, .friction = {0.6, 0.35}};
  const auto slide = [](double t, const State& y) { return State{y[1], 2.2 / 0.3 * std::sin(7 * t) - 0.35 * 9.81}; };
  const auto stuck = [](double, const State&) { return State{0, 0}; };
  const Point onset = integrate_until(
      stuck, {0, {0, 0}}, [](double t, const State&) { return 2.2 * std::sin(7 * t) - 0.6 * 0.3 * 9.81; }, 0.2);
  EXPECT_NEAR(slip_onset(h), onset.t, integration);
  const Point stop = integrate_until(
      slide, onset, [&](double t, const State& y) { return t > onset.t + 0.01 ? -y[1] : -1; }, 0.8);
  EXPECT_NEAR(stop_time(h), stop.t, integration);
  EXPECT_NEAR(slip(h), stop.y[0], integration);
}

TEST(HarmonicForce, HoldsBelowItsThreshold) {
  const HarmonicForce h{.mass = 0.2, .force = 0.98, .friction = {0.5, 0.4}};
  EXPECT_FALSE(slips(h));
  EXPECT_EQ(slip(h), 0);
  EXPECT_TRUE(std::isnan(slip_onset(h)));
}

TEST(FrictionOscillator, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C06");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const FrictionOscillator o{
        s.given("m"), s.given("k"), s.given("x0"), s.given("g"), {s.given("mu_s"), s.given("mu_d")}};
    EXPECT_EQ(half_swings(o), s.expected.at("nhalf").get<int>());
    EXPECT_NEAR(stop_time(o), s.number("t"), catalogue);
    EXPECT_NEAR(turning_point(o, half_swings(o)), s.number("x"), catalogue);
  }
}

TEST(FrictionOscillator, SwingsAsIntegrationSays) {
  const FrictionOscillator o{.mass = 0.3, .stiffness = 80, .start = -0.09, .friction = {0.4, 0.3}};
  Point p{0, {-0.09, 0}};
  double direction = 1;
  int swings = 0;
  for (; std::abs(80 * p.y[0]) > 0.4 * 0.3 * 9.81; ++swings) {
    const auto rates = [&](double, const State& y) {
      return State{y[1], (-80 * y[0] - direction * 0.3 * 0.3 * 9.81) / 0.3};
    };
    const double began = p.t;
    const auto stops = [&](double t, const State& y) { return t > began + 0.01 ? -direction * y[1] : -1; };
    p = integrate_until(rates, p, stops, 0.5);
    p.y[1] = 0;
    direction = -direction;
    EXPECT_NEAR(turning_point(o, swings + 1), p.y[0], integration);
  }
  EXPECT_EQ(half_swings(o), swings);
  EXPECT_NEAR(stop_time(o), p.t, integration);
}

TEST(DenHartog, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C07");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const DenHartog d{s.given("m"), s.given("k"), s.given("F0"), s.given("w"), s.given("mu"), s.given("g")};
    EXPECT_NEAR(amplitude(d), s.number("X"), catalogue);
    EXPECT_NEAR(position(d, pi / d.frequency), s.number("x_half"), catalogue);
    EXPECT_NEAR(dissipation(d), s.number("diss"), catalogue);
  }
}

/// From the claimed start, half a cycle of integration must end at rest on the other side, without a stop between.
TEST(DenHartog, IsAFixedPointOfIntegration) {
  for (const DenHartog& d : {DenHartog{.force = 0.9, .frequency = 11, .mu = 0.15},
                             DenHartog{.mass = 0.1, .stiffness = 60, .force = 1.5, .frequency = 33, .mu = 0.1}}) {
    const auto rates = [&](double t, const State& y) {
      const double force = d.force * std::cos(d.frequency * t + phase(d)) - d.stiffness * y[0];
      return State{y[1], force / d.mass + d.mu * d.gravity};
    };
    const Point start{0, {amplitude(d), 0}};
    const double half = pi / d.frequency;
    for (int i = 1; i < 20; ++i) {
      const Point p = integrate(rates, start, half * i / 20);
      EXPECT_LT(p.y[1], 0);
      EXPECT_NEAR(position(d, half * i / 20), p.y[0], 1e-11);
    }
    const Point end = integrate(rates, start, half);
    EXPECT_NEAR(end.y[0], -amplitude(d), 1e-11);
    EXPECT_NEAR(end.y[1], 0, 1e-10);
    EXPECT_NEAR(position(d, 2.3 * half), position(d, 0.3 * half), 1e-15);
  }
}

TEST(BeltOscillator, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C08");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const BeltOscillator b{s.given("m"), s.given("k"), s.given("V"), s.given("g"), {s.given("mu_s"), s.given("mu_d")}};
    EXPECT_NEAR(stick_time(b), s.number("T_stick"), catalogue);
    EXPECT_NEAR(slip_time(b), s.number("T_slip"), catalogue);
    EXPECT_NEAR(greatest_position(b), s.number("x_max"), catalogue);
    EXPECT_NEAR(least_position(b), s.number("x_min"), catalogue);
  }
}

TEST(BeltOscillator, SlipsAsIntegrationSays) {
  const BeltOscillator b{.mass = 0.15, .stiffness = 70, .speed = 0.08, .friction = {0.7, 0.3}};
  const double mg = 0.15 * 9.81;
  const auto slide = [&](double, const State& y) { return State{y[1], (0.3 * mg - 70 * y[0]) / 0.15}; };
  const Point start{0, {0.7 * mg / 70, 0.08}};  // breakaway: the spring takes all friction can give
  const Point end = integrate_until(
      slide, start, [](double t, const State& y) { return t > 0.01 ? y[1] - 0.08 : -1; }, 0.5);
  EXPECT_NEAR(slip_time(b), end.t, integration);
  EXPECT_NEAR(restick_position(b), end.y[0], integration);
  EXPECT_NEAR(stick_time(b), (start.y[0] - end.y[0]) / 0.08, integration);
  EXPECT_NEAR(position(b, stick_time(b) + 0.1), integrate(slide, start, 0.1).y[0], 1e-12);
  const Point highest = integrate_until(
      slide, start, [](double, const State& y) { return -y[1]; }, 0.3);
  EXPECT_NEAR(greatest_position(b), highest.y[0], 1e-12);
}

TEST(OscillatingPalm, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C09");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const OscillatingPalm p{s.given("A"), s.given("w"), s.given("mu"), s.given("g")};
    const bool stick = s.expected.at("regime") == "stick";
    EXPECT_EQ(sticks(p), stick);
    EXPECT_EQ(slides_throughout(p), !stick);
    EXPECT_NEAR(peak_speed(p), s.number("v_peak"), catalogue);
    EXPECT_NEAR(slip_per_cycle(p), s.number("slip"), catalogue);
    if (!stick) {
      EXPECT_NEAR(switching_phase(p), s.number("phase"), catalogue);
    }
  }
}

TEST(OscillatingPalm, IsAFixedPointOfIntegration) {
  const OscillatingPalm p{.amplitude = 0.03, .frequency = 30, .mu = 0.3};
  ASSERT_TRUE(slides_throughout(p));
  const double begin = switching_phase(p) / 30;
  const auto rates = [](double t, const State& y) {  // the palm falls behind; friction brakes
    return State{-0.3 * 9.81, 0.03 * 30 * std::cos(30 * t) - y[0]};
  };
  const Point end = integrate(rates, {begin, {peak_speed(p), 0}}, begin + pi / 30);
  EXPECT_NEAR(end.y[0], -peak_speed(p), 1e-11);
  EXPECT_NEAR(0.03 * 30 * std::cos(30 * end.t), end.y[0], 1e-11);  // it meets the palm's speed there: turns again
  EXPECT_NEAR(slip_per_cycle(p), -2 * end.y[1], 1e-11);
}

}  // namespace
}  // namespace handhold::closed_form
