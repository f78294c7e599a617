// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/curved_slide.hpp"

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

Dome dome(const testing::ExpectedSet& s) {
  return {s.given("R"), s.given("mu"), s.given("th0"), s.given("v0"), s.given("g")};
}

TEST(Dome, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C14");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    EXPECT_NEAR(lift_off_angle(dome(s)), s.number("th"), catalogue);
    EXPECT_NEAR(lift_off_speed(dome(s)), s.number("v"), catalogue);
    EXPECT_NEAR(lift_off_time(dome(s)), s.number("t"), 1e-10);  // the catalogue's quadrature is good to 5e-11
  }
}

TEST(Dome, SlidesAsIntegrationSays) {
  for (const Dome& d : {Dome{0.2, 0.25, 0.4, 0, 9.81}, Dome{0.15, 0.4, 0.05, 0.8, 9.81}}) {
    const auto normal = [&](const State& y) { return 9.81 * std::cos(y[0]) - d.radius * y[1] * y[1]; };
    const auto rates = [&](double, const State& y) {
      return State{y[1], (9.81 * std::sin(y[0]) - d.mu * normal(y)) / d.radius};
    };
    const Point end = integrate_until(
        rates, {0, {d.start_angle, d.start_speed / d.radius}}, [&](double, const State& y) { return -normal(y); }, 3);
    EXPECT_NEAR(lift_off_angle(d), end.y[0], 1e-10);
    EXPECT_NEAR(lift_off_speed(d), end.y[1] * d.radius, 1e-10);
    EXPECT_NEAR(lift_off_time(d), end.t, 1e-10);
  }
}

TEST(Dome, StopsWhenTooSlow) {
  EXPECT_TRUE(std::isnan(lift_off_angle({.mu = 0.5, .start_angle = 0.1, .start_speed = 0.1})));
}

TEST(Bowl, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C15");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const Bowl b{s.given("R"), s.given("th0"), s.given("g"), {s.given("mu_s"), s.given("mu_d")}};
    const std::vector<double> angles = turning_angles(b);
    ASSERT_EQ(angles.size(), s.expected.at("turns").size());
    for (std::size_t i = 0; i < angles.size(); ++i)
      EXPECT_NEAR(angles[i], s.expected.at("turns")[i].get<double>(), catalogue);
  }
}

TEST(Bowl, SwingsAsIntegrationSays) {
  const Bowl b{0.12, -1.3, 9.81, {0.3, 0.15}};
  const std::vector<double> angles = turning_angles(b), times = turning_times(b);
  Point p{0, {-1.3, 0}};
  double direction = 1;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const auto rates = [&](double, const State& y) {
      const double N = 9.81 * std::cos(y[0]) + 0.12 * y[1] * y[1];
      return State{y[1], (-9.81 * std::sin(y[0]) - direction * 0.15 * N) / 0.12};
    };
    const double began = p.t;
    p = integrate_until(
        rates, p, [&](double t, const State& y) { return t > began + 0.01 ? -direction * y[1] : -1; }, 1);
    EXPECT_NEAR(angles[i], p.y[0], 1e-10);
    EXPECT_NEAR(times[i], p.t, 1e-10);
    p.y[1] = 0;
    direction = -direction;
  }
  EXPECT_LE(std::tan(std::abs(angles.back())), 0.3);
  EXPECT_GT(std::tan(std::abs(angles[angles.size() - 2])), 0.3);
}

TEST(WallSlide, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C16");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const WallSlide w{s.given("R"), s.given("mu_w"), s.given("mu_f"), s.given("v0"), s.given("g")};
    EXPECT_NEAR(stop_time(w), s.number("t"), catalogue);
    EXPECT_NEAR(swept_angle(w), s.number("ang"), catalogue);
  }
}

TEST(WallSlide, SlidesAsIntegrationSays) {
  const WallSlide w{0.3, 0.4, 0.15, 2, 9.81};
  const auto rates = [](double, const State& y) { return State{y[1] / 0.3, -0.4 / 0.3 * y[1] * y[1] - 0.15 * 9.81}; };
  const Point middle = integrate(rates, {0, {0, 2}}, 0.3);
  EXPECT_NEAR(angle_at(w, 0.3), middle.y[0], 1e-11);
  EXPECT_NEAR(speed_at(w, 0.3), middle.y[1], 1e-11);
  const Point end = integrate_until(
      rates, {0, {0, 2}}, [](double, const State& y) { return -y[1]; }, 2);
  EXPECT_NEAR(stop_time(w), end.t, 1e-11);
  EXPECT_NEAR(swept_angle(w), end.y[0], 1e-11);
  EXPECT_NEAR(angle_at(w, 9), end.y[0], 1e-11);
}

}  // namespace
}  // namespace handhold::closed_form
