// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/pushed_block.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/cases/closed_form/expected_json.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using testing::expected_sets;
using testing::integrate;
using testing::integrate_until;
using testing::Point;
using testing::State;

constexpr double catalogue = 1e-12;

TEST(Flick, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C02");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const Flick f{s.given("th"), s.given("v0"), s.given("g"), {s.given("mu_s"), s.given("mu_d")}};
    EXPECT_NEAR(stop_time(f), s.number("t_up"), catalogue);
    EXPECT_NEAR(stop_distance(f), s.number("D"), catalogue);
    EXPECT_EQ(returns(f), s.expected.at("ret").get<bool>());
    EXPECT_NEAR(return_speed(f), s.number("v_ret"), catalogue);
    EXPECT_NEAR(return_time(f), s.number("t_dn"), catalogue);
  }
}

TEST(Flick, MovesAsIntegrationSays) {
  const Flick f{0.8, 1.4, 9.81, {0.6, 0.3}};
  const auto rates = [](double direction) {
    return [=](double, const State& y) {
      return State{y[1], -9.81 * std::sin(0.8) - direction * 0.3 * 9.81 * std::cos(0.8)};
    };
  };
  const Point top = integrate_until(
      rates(1), {0, {0, 1.4}}, [](double, const State& y) { return -y[1]; }, 1);
  EXPECT_NEAR(stop_time(f), top.t, 1e-11);
  EXPECT_NEAR(stop_distance(f), top.y[0], 1e-11);
  const Point end = integrate_until(
      rates(-1), {top.t, {top.y[0], 0}}, [](double, const State& y) { return -y[0]; }, 1);
  EXPECT_NEAR(return_speed(f), -end.y[1], 1e-10);
  EXPECT_NEAR(return_time(f), end.t - top.t, 1e-10);
}

TEST(LoadRamp, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C04");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const LoadRamp l{s.given("m"), s.given("r"), s.given("g"), {s.given("mu_s"), s.given("mu_d")}};
    EXPECT_NEAR(slip_onset(l), s.number("t_s"), catalogue);
    EXPECT_NEAR(distance(l, s.given("T")), s.number("x"), catalogue);
    EXPECT_NEAR(speed(l, s.given("T")), s.number("v"), catalogue);
  }
}

TEST(LoadRamp, MovesAsIntegrationSays) {
  const LoadRamp l{0.3, 5, 9.81, {0.7, 0.45}};
  const auto rates = [](double t, const State& y) { return State{y[1], 5 * t / 0.3 - 0.45 * 9.81}; };
  const Point end = integrate(rates, {0.7 * 0.3 * 9.81 / 5, {0, 0}}, 0.9);
  EXPECT_NEAR(distance(l, 0.9), end.y[0], 1e-12);
  EXPECT_NEAR(speed(l, 0.9), end.y[1], 1e-12);
  EXPECT_EQ(distance(l, 0.4), 0);
}

/// Newton's law in the plane, in coordinates that know nothing of angles.
TEST(ObliqueSlide, TurnsAsIntegrationSays) {
  for (const double slope : {0.3, 0.7}) {  // it stops; it does not
    const ObliqueSlide s{slope, 0.45, 1.2, 2.1, 9.81};
    const auto rates = [&](double, const State& y) {
      const double speed = std::hypot(y[2], y[3]), a = 0.45 * 9.81 * std::cos(slope) / speed;
      return State{y[2], y[3], 9.81 * std::sin(slope) - a * y[2], -a * y[3]};
    };
    const Point start{0, {0, 0, 1.2 * std::cos(2.1), 1.2 * std::sin(2.1)}};
    for (const double angle : {1.8, 0.9, 0.2}) {
      const Point p = integrate_until(
          rates, start, [&](double, const State& y) { return angle - std::atan2(y[3], y[2]); }, 3);
      const ObliquePoint at = at_angle(s, angle);
      EXPECT_NEAR(at.t, p.t, 1e-10);
      EXPECT_NEAR(at.downhill, p.y[0], 1e-10);
      EXPECT_NEAR(at.across, p.y[1], 1e-10);
      EXPECT_NEAR(at.speed, std::hypot(p.y[2], p.y[3]), 1e-10);
    }
  }
}

}  // namespace
}  // namespace handhold::closed_form
