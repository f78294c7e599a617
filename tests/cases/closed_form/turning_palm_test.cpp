// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/turning_palm.hpp"

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

TEST(TiltingPalm, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C11");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const TiltingPalm p{s.given("x0"), s.given("Om"), s.given("g"), {s.given("mu"), s.given("mu")}};
    EXPECT_NEAR(onset_angle(p), s.number("th_s"), catalogue);
    EXPECT_NEAR(slip_onset(p), s.number("t_s"), catalogue);
    EXPECT_NEAR(place(p, slip_onset(p) + s.given("T")), s.number("x"), catalogue);
    EXPECT_NEAR(speed(p, slip_onset(p) + s.given("T")), s.number("v"), catalogue);
  }
}

/// In W, not in the palm's frame: the object's acceleration is gravity and the contact's force along n − μ t, with N
/// such that the object stays on the palm. Its place is (x, z); no Coriolis term is written.
TEST(TiltingPalm, SlidesAsIntegrationInSpaceSays) {
  const TiltingPalm p{0.1, 1.3, 9.81, {0.5, 0.3}};
  const double begin = slip_onset(p), end = begin + 0.25, W = 1.3;
  const auto rates = [&](double t, const State& y) {
    const double c = std::cos(W * t), s = std::sin(W * t);  // n = (−s, c), n' = −W (c, s), n'' = −W² n
    // 0 = d²/dt² (n · r) = n · a + 2 n' · v + n'' · r, with a = (0, −g) + N ((−s, c) + μ (c, s))
    const double held = -2 * W * (c * y[2] + s * y[3]) - W * W * (-s * y[0] + c * y[1]);
    const double N = 9.81 * c - held;
    return State{y[2], y[3], N * (-s + 0.3 * c), -9.81 + N * (c + 0.3 * s)};
  };
  const double a = W * begin;
  const Point y = integrate(
      rates, {begin, {0.1 * std::cos(a), 0.1 * std::sin(a), -0.1 * W * std::sin(a), 0.1 * W * std::cos(a)}}, end);
  const double x = place(p, end), v = speed(p, end), b = W * end;
  EXPECT_NEAR(x * std::cos(b), y.y[0], 1e-11);
  EXPECT_NEAR(x * std::sin(b), y.y[1], 1e-11);
  EXPECT_NEAR(v * std::cos(b) - W * x * std::sin(b), y.y[2], 1e-11);
  EXPECT_NEAR(v * std::sin(b) + W * x * std::cos(b), y.y[3], 1e-11);
  const double held = -2 * W * (std::cos(b) * y.y[2] + std::sin(b) * y.y[3]);
  EXPECT_NEAR(normal_acceleration(p, end), 9.81 * std::cos(b) - held, 1e-10);
}

TEST(SpunPalm, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("C12");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const SpunPalm p{s.given("R"), s.given("al"), s.given("g"), s.given("mu")};
    EXPECT_NEAR(slip_onset(p), s.number("t_s"), catalogue);
    EXPECT_NEAR(p.acceleration * slip_onset(p) * slip_onset(p) / 2, s.number("th"), catalogue);
    EXPECT_NEAR(std::abs(slip_direction(p)), s.number("dir"), catalogue);
  }
}

/// In W: the only force is friction, against the velocity over the palm's matter. Started a little after the onset,
/// where the direction is no longer 0/0, on the slide's own state.
TEST(SpunPalm, SlidesAsIntegrationInSpaceSays) {
  const SpunPalm p{0.1, 8, 9.81, 0.5};
  const double begin = slip_onset(p) + 1e-3, end = slip_onset(p) + 0.05;
  const auto rates = [&](double t, const State& y) {
    const double w = 8 * t, ux = y[2] + w * y[1], uy = y[3] - w * y[0], a = 0.4 * 9.81 / std::hypot(ux, uy);
    return State{y[2], y[3], -a * ux, -a * uy};
  };
  const SpunPlace from = slide(p, 0.4, begin), to = slide(p, 0.4, end);
  const Point y = integrate(rates, {begin, {from.p.x(), from.p.y(), from.v.x(), from.v.y()}}, end);
  EXPECT_NEAR(to.p.x(), y.y[0], 1e-11);
  EXPECT_NEAR(to.p.y(), y.y[1], 1e-11);
  EXPECT_NEAR(to.v.x(), y.y[2], 1e-10);
  EXPECT_NEAR(to.v.y(), y.y[3], 1e-10);
  // It begins with the palm: along its way, at w R.
  const SpunPlace first = slide(p, 0.4, slip_onset(p));
  EXPECT_NEAR(first.p.norm(), 0.1, 1e-15);
  EXPECT_NEAR(first.v.norm(), 0.1 * 8 * slip_onset(p), 1e-14);
  EXPECT_NEAR(first.p.dot(first.v), 0, 1e-15);
}

TEST(TurntableBall, AgreesWithTheCatalogue) {
  const auto sets = expected_sets("E06");
  if (sets.empty()) GTEST_SKIP() << "no expected.json";
  for (const auto& s : sets) {
    const TurntableBall b{
        s.given("r"), s.given("beta"), s.given("Om"), {s.given("x0"), 0}, {s.given("vx"), s.given("vy")}};
    EXPECT_NEAR(period(b), s.number("period"), catalogue);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(position(b, s.given("T"))[i], s.expected.at("x")[std::size_t(i)].get<double>(), catalogue);
      EXPECT_NEAR(velocity(b, s.given("T"))[i], s.expected.at("v")[std::size_t(i)].get<double>(), catalogue);
    }
  }
}

/// Newton and Euler with the friction that rolling asks for: m v' = f, β m r² ω' = −r z × f, and r ω × z = v − Ω z × x
/// differentiated gives f (1 + 1/β) = m Ω z × v.
TEST(TurntableBall, RollsAsItsSpinSays) {
  const TurntableBall b{0.02, 0.5, 7, {0.05, -0.02}, {0.05, 0.1}};
  const auto rates = [](double, const State& y) {
    const double fx = -7 * y[3] / (1 + 1 / 0.5), fy = 7 * y[2] / (1 + 1 / 0.5);  // per mass
    return State{y[2], y[3], fx, fy, fy / (0.5 * 0.02), -fx / (0.5 * 0.02)};     // ω' = −z × f / (β r)
  };
  const Eigen::Vector2d w = spin(b, 0);
  const Point y = integrate(rates, {0, {0.05, -0.02, 0.05, 0.1, w.x(), w.y()}}, 0.9);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(position(b, 0.9)[i], y.y[std::size_t(i)], 1e-11);
    EXPECT_NEAR(velocity(b, 0.9)[i], y.y[std::size_t(i) + 2], 1e-11);
    EXPECT_NEAR(spin(b, 0.9)[i], y.y[std::size_t(i) + 4], 1e-9);
  }
}

}  // namespace
}  // namespace handhold::closed_form
