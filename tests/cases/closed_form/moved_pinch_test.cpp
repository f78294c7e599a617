// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/moved_pinch.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/cases/closed_form/expected_json.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using testing::expected_sets;
using testing::integrate_until;
using testing::Point;
using testing::State;

constexpr double catalogue = 1e-12;

TEST(PinchCatch, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("D03");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const PinchCatch p{s.given("m"),  s.given("N0"), s.given("r"),
                       s.given("v0"), s.given("g"),  {s.given("mu_s"), s.given("mu_d")}};
    EXPECT_NEAR(stop_time(p), s.number("t"), catalogue);
    EXPECT_NEAR(slip(p), s.number("slip"), catalogue);
  }
}

TEST(PinchCatch, StopsAsIntegrationSays) {
  const PinchCatch p{0.3, 1.5, 11, 0.5, 9.81, {0.6, 0.45}};
  const auto rates = [](double t, const State& y) { return State{y[1], 9.81 - 2 * 0.45 * (1.5 + 11 * t) / 0.3}; };
  const Point end = integrate_until(
      rates, {0, {0, 0.5}}, [](double, const State& y) { return -y[1]; }, 2);
  EXPECT_NEAR(stop_time(p), end.t, 1e-11);
  EXPECT_NEAR(slip(p), end.y[0], 1e-11);
}

TEST(VerticalShake, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("D04");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& e : sets) {
    const VerticalShake s{e.given("m"), e.given("N"), e.given("A"),
                          e.given("w"), e.given("g"), {e.given("mu_s"), e.given("mu_d")}};
    EXPECT_EQ(slips(s), e.expected.at("slips").get<bool>());
    EXPECT_NEAR(greatest_acceleration(s), e.number("a_max"), catalogue);
    EXPECT_NEAR(slip(s), e.number("slip"), catalogue);
    if (!slips(s)) continue;
    EXPECT_NEAR(slip_onset(s), e.number("t1"), catalogue);
    EXPECT_NEAR(stop_time(s), e.number("t2"), catalogue);
  }
}

TEST(VerticalShake, SlipsAsIntegrationSays) {
  const VerticalShake s{0.25, 3.5, 0.03, 16, 9.81, {0.5, 0.4}};
  const auto hand_acceleration = [](double t) { return -0.03 * 256 * std::sin(16 * t); };
  const auto stuck = [](double, const State&) { return State{0, 0}; };
  const Point onset = integrate_until(
      stuck, {0, {0, 0}}, [&](double t, const State&) { return 9.81 + hand_acceleration(t) - 2 * 0.5 * 3.5 / 0.25; },
      0.5);
  EXPECT_NEAR(slip_onset(s), onset.t, 1e-11);
  const auto slide = [&](double t, const State& y) {
    return State{y[1], 2 * 0.4 * 3.5 / 0.25 - 9.81 - hand_acceleration(t)};
  };
  const Point end = integrate_until(
      slide, onset, [&](double t, const State& y) { return t > onset.t + 0.005 ? y[1] : -1; }, 0.5);
  EXPECT_NEAR(stop_time(s), end.t, 1e-10);
  EXPECT_NEAR(slip(s), end.y[0], 1e-10);
}

TEST(SideShake, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("D06");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& e : sets) {
    const SideShake s{e.given("m"), e.given("N"), e.given("A"), e.given("w"), e.given("g"), e.given("mu_s")};
    EXPECT_NEAR(slip_onset(s), e.number("t"), catalogue);
    EXPECT_NEAR(acceleration_at_onset(s), e.number("ax"), catalogue);
    EXPECT_FALSE(holds(s));
  }
}

TEST(SideShake, FrictionReachesTheConeThere) {
  const SideShake s{0.15, 2.4, 0.06, 17, 9.81, 0.55};
  const auto overload = [](double t, const State&) {
    return std::hypot(0.15 * 9.81, 0.15 * 0.06 * 289 * std::sin(17 * t)) - 2 * 0.55 * 2.4;
  };
  const auto stuck = [](double, const State&) { return State{0}; };
  const Point onset = integrate_until(stuck, {0, {0}}, overload, 0.09);
  EXPECT_NEAR(slip_onset(s), onset.t, 1e-12);
  const Eigen::Vector2d friction(-0.06 * 289 * std::sin(17 * onset.t), 9.81);  // per mass, what the object needs
  EXPECT_NEAR(friction.normalized().dot(slip_direction(s)), -1, 1e-12);
  EXPECT_NEAR(slip_direction(s).norm(), 1, 1e-14);
}

/// Against GSL's adaptive steps, begun a little later where the direction is no longer 0/0; and the first microseconds
/// go along the closed direction.
TEST(SideShake, SlidesAsIntegrationSays) {
  const SideShake s{};
  const double begin = slip_onset(s) + 1e-3, end = slip_onset(s) + 0.03, c = 2 * 0.4 * s.normal_force / s.mass;
  const auto rates = [&](double t, const State& y) {
    const double u = std::hypot(y[2], y[3]), a = s.amplitude * s.frequency * s.frequency * std::sin(s.frequency * t);
    return State{y[2], y[3], a - c * y[2] / u, -s.gravity - c * y[3] / u};
  };
  const PlaneSlide from = slide(s, 0.4, begin), to = slide(s, 0.4, end);
  const Point y = testing::integrate(rates, {begin, {from.x[0], from.x[1], from.u[0], from.u[1]}}, end);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(to.x[i], y.y[std::size_t(i)], 1e-12);
    EXPECT_NEAR(to.u[i], y.y[std::size_t(i) + 2], 1e-11);
  }
  EXPECT_NEAR((slide(s, 0.4, slip_onset(s) + 1e-5).u.normalized() - slip_direction(s)).norm(), 0, 1e-3);
}

}  // namespace
}  // namespace handhold::closed_form
