// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/rolling.hpp"

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
constexpr double integration = 1e-9;  // GSL at 1e-13 a step, events to the last bit

TEST(SlidingBall, AgreesWithTheCatalogueOnALine) {
  const auto sets = expected_sets("E01");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const SlidingBall b{s.given("r"), s.given("beta"), s.given("mu"), {s.given("v0"), 0}, {0, s.given("w0"), 0}, 9.81};
    EXPECT_NEAR(roll_time(b), s.number("t"), catalogue);
    EXPECT_NEAR(roll_velocity(b).x(), s.number("v"), catalogue);
    EXPECT_NEAR(position(b, roll_time(b)).x(), s.number("x"), catalogue);
    EXPECT_NEAR(s.given("m") * heat_per_mass(b), s.number("loss"), catalogue);
  }
}

TEST(SlidingBall, AgreesWithTheCatalogueOnAParabola) {
  const auto sets = expected_sets("E02");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const SlidingBall b{s.given("r"),
                        s.given("beta"),
                        s.given("mu"),
                        {s.given("vx"), s.given("vy")},
                        {s.given("wx"), s.given("wy"), s.given("wz")},
                        s.given("g")};
    EXPECT_NEAR(roll_time(b), s.number("t"), catalogue);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(position(b, roll_time(b))[i], s.expected.at("pos")[std::size_t(i)].get<double>(), catalogue);
      EXPECT_NEAR(roll_velocity(b)[i], s.expected.at("v")[std::size_t(i)].get<double>(), catalogue);
    }
  }
}

/// Newton and Euler with friction along the momentary sliding velocity; that its direction is constant is not assumed.
TEST(SlidingBall, SlidesAsIntegrationSays) {
  const SlidingBall b{0.05, 0.6, 0.2, {0.4, -0.9}, {12, -25, 3}, 9.81};
  const auto sliding = [](const State& y) { return State{y[2] - 0.05 * y[5], y[3] + 0.05 * y[4]}; };
  const auto rates = [&](double, const State& y) {
    const State u = sliding(y);
    const double a = 0.2 * 9.81 / std::hypot(u[0], u[1]);
    const double fx = -a * u[0], fy = -a * u[1];  // per mass, at −r z: torque −r z × f = r (fy, −fx)
    return State{y[2], y[3], fx, fy, 0.05 * fy / (0.6 * 0.05 * 0.05), -0.05 * fx / (0.6 * 0.05 * 0.05)};
  };
  const Point start{0, {0, 0, 0.4, -0.9, 12, -25}};
  const double t = 0.9 * roll_time(b);
  const Point p = integrate(rates, start, t);
  EXPECT_NEAR(position(b, t).x(), p.y[0], 1e-11);
  EXPECT_NEAR(position(b, t).y(), p.y[1], 1e-11);
  const State u = sliding(p.y);
  EXPECT_NEAR(std::hypot(u[0], u[1]), 0.1 * sliding_velocity(b).norm(), 1e-10);  // falls evenly to zero
  const Eigen::Vector2d left = 0.1 * sliding_velocity(b) / (1 + 1 / 0.6);        // what friction will yet take
  EXPECT_NEAR(roll_velocity(b).x(), p.y[2] - left.x(), 1e-10);
  EXPECT_NEAR(roll_velocity(b).y(), p.y[3] - left.y(), 1e-10);
}

TEST(RolledBall, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("E03");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const RolledBall b{s.given("m"), s.given("r"), s.given("beta"), s.given("N"), s.given("mu"), s.given("j")};
    EXPECT_NEAR(slip_onset(b), s.number("t_s"), catalogue);
    const double end = slip_onset(b) + s.given("T");
    EXPECT_NEAR(position(b, end), s.number("xc"), catalogue);
    EXPECT_NEAR(slip(b, end), s.number("slip"), catalogue);
    EXPECT_NEAR(position(b, end) / b.radius, s.number("angle"), 20 * catalogue);
  }
}

/// Centre and spin under the two friction forces, each found from the rolling it must maintain (2 × 2, by hand).
TEST(RolledBall, RollsAndSlipsAsIntegrationSays) {
  const RolledBall b{.mass = 0.15, .radius = 0.03, .beta = 0.5, .normal_force = 2, .mu = 0.3, .jerk = 40};
  // m x'' = T + B, beta m r w' = T − B; upper material x' + r w = V, lower x' = r w.
  const auto upper_force = [](double t) {
    const double a = 40 * t / 2;  // of the centre
    return 0.15 * a * (1 + 0.5) / 2;
  };
  const auto rates = [&](double t, const State& y) {
    const double T = std::min(upper_force(t), 0.3 * 2);
    const double B = T * (1 - 0.5) / (1 + 0.5);  // keeps x'' = r w'
    return State{y[1], (T + B) / 0.15};
  };
  const Point onset = integrate_until(
      rates, {0, {0, 0}}, [&](double t, const State&) { return upper_force(t) - 0.6; }, 1);
  EXPECT_NEAR(slip_onset(b), onset.t, 1e-12);
  EXPECT_NEAR(position(b, onset.t), onset.y[0], 1e-11);
  const Point end = integrate(rates, onset, onset.t + 0.3);
  EXPECT_NEAR(position(b, end.t), end.y[0], 1e-11);
}

TEST(CarriedBall, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("E04");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const CarriedBall b{s.given("m"),  s.given("r"),  s.given("beta"), s.given("N"),
                        s.given("mu"), s.given("V1"), s.given("V2")};
    EXPECT_NEAR(roll_time(b), s.number("t"), catalogue);
    EXPECT_NEAR(roll_speed(b), s.number("vc"), catalogue);
    EXPECT_NEAR(roll_spin(b), s.number("w"), catalogue);
  }
}

/// Work of the plates = heat + energy, with the forces integrated by GSL.
TEST(CarriedBall, SpinsUpAsIntegrationSays) {
  const double m = 0.12, r = 0.03, beta = 0.4, friction = 0.35 * 1.5;
  for (const double lower : {0.0, -0.3, 0.3}) {
    const CarriedBall b{m, r, beta, 1.5, 0.35, 0.3, lower};
    const auto rates = [&](double, const State& y) {  // x', w, heat
      const double T = friction;                      // the upper plate is ahead
      const double B = lower == 0 ? T * (1 - beta) / (1 + beta) : std::copysign(friction, lower);
      const double heat = T * (0.3 - y[0] - r * y[1]) + (lower == 0 ? 0 : B * (lower - y[0] + r * y[1]));
      return State{(T + B) / m, (T - B) / (beta * m * r), heat};
    };
    const Point end = integrate_until(
        rates, {0, {0, 0, 0}}, [&](double, const State& y) { return y[0] + r * y[1] - 0.3; }, 0.5);
    EXPECT_NEAR(roll_time(b), end.t, 1e-11) << lower;
    EXPECT_NEAR(roll_speed(b), end.y[0], 1e-11) << lower;
    EXPECT_NEAR(roll_spin(b), end.y[1], 1e-9) << lower;
    EXPECT_NEAR(heat(b), end.y[2], 1e-11) << lower;
  }
}

TEST(RollDown, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("E05");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const RollDown b{s.given("r"), s.given("beta"), s.given("th"), s.given("mu"), s.given("g")};
    EXPECT_EQ(rolls(b), s.expected.at("mode") == "roll");
    EXPECT_NEAR(time_at(b, s.given("D")), s.number("t"), catalogue);
    EXPECT_NEAR(spin_at(b, s.given("D")), s.number("w"), 100 * catalogue);
  }
}

TEST(RollDown, RollsAsIntegrationSays) {
  for (const double slope : {0.6, 1.1}) {
    const RollDown b{0.04, 0.4, slope, 0.25, 9.81};
    const double N = 9.81 * std::cos(slope), pull = 9.81 * std::sin(slope);
    const double needed = pull * 0.4 / 1.4;  // per mass, from x'' = r w'
    const double f = std::min(needed, 0.25 * N);
    EXPECT_EQ(rolls(b), needed <= 0.25 * N);
    const auto rates = [&](double, const State& y) { return State{y[1], pull - f, f / (0.4 * 0.04)}; };
    const Point end = integrate_until(
        rates, {0, {0, 0, 0}}, [](double, const State& y) { return y[0] - 0.3; }, 2);
    EXPECT_NEAR(time_at(b, 0.3), end.t, integration);
    EXPECT_NEAR(spin_at(b, 0.3), end.y[2], 100 * integration);
  }
}

}  // namespace
}  // namespace handhold::closed_form
