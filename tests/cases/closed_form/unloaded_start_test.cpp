// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/unloaded_start.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "tests/cases/closed_form/integrate.hpp"

namespace handhold::closed_form {
namespace {

using testing::integrate;
using testing::integrate_until;
using testing::Point;
using testing::State;

UnloadedStart half_a_kilogram(double degrees, double stiffness, double damping) {
  return {.incline = {.slope = degrees * std::numbers::pi / 180, .friction = {.mu_static = 0.5, .mu_dynamic = 0.5}},
          .mass = 0.5,
          .stiffness = stiffness,
          .damping = damping};
}

/// m x'' = m g sin θ − K x − C x' to the edge of the cone, then friction of the cone: ringing, critical (ω0 = 400 1/s),
/// and hardly moving.
TEST(UnloadedStart, AgreesWithIntegrationOfNewtonsLaw) {
  for (const double C : {80.0, 400.0, 16000.0}) {
    const UnloadedStart start = half_a_kilogram(30, 8e4, C);
    const double along = 0.5 * 9.81 * std::sin(start.incline.slope), cone = 0.25 * 9.81 * std::cos(start.incline.slope);
    const auto stick = [=](double, const State& y) { return State{y[1], (along - 8e4 * y[0] - C * y[1]) / 0.5}; };
    const auto slide = [=](double, const State& y) { return State{y[1], (along - cone) / 0.5}; };
    const auto force = [=](double, const State& y) { return 8e4 * y[0] + C * y[1] - cone; };
    const Point broken = integrate_until(stick, {0, {0, 0}}, force, 1);
    EXPECT_NEAR(breakaway_time(start), broken.t, 1e-9 * broken.t) << C;
    EXPECT_NEAR(slip(start, 0.5 * broken.t), integrate(stick, {0, {0, 0}}, 0.5 * broken.t).y[0], 1e-12) << C;
    EXPECT_NEAR(slip(start, 1), integrate(slide, broken, 1).y[0], 1e-10) << C;
  }
}

/// A light damper lets the springs pull up to twice the weight's part along the slope, a strong one hardly
/// more than once: the slope is 2.5 % below its limit.
TEST(UnloadedStart, OvershootCanBreakWhatWouldHold) {
  EXPECT_LT(breakaway_time(half_a_kilogram(26, 8e4, 80)), 0.01);
  EXPECT_EQ(breakaway_time(half_a_kilogram(26, 8e4, 16000)), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(slip(half_a_kilogram(26, 8e4, 16000), 100), 0.5 * 9.81 * std::sin(26 * std::numbers::pi / 180) / 8e4,
              1e-12);  // hangs on its springs
}

/// Rigid and compliant truth of the slopes of S3 differ by less than a third of what the benchmark allows: 0.1 % of the
/// distance, 0.1 mm of a block that must stay.
TEST(UnloadedStart, SpringsHaveNoShareInTheBenchmark) {
  for (const double degrees : {24.0, 26.0, 30.0, 45.0}) {
    const auto made = catalogue::benchmark_scene("S3-" + std::to_string(int(degrees)));
    const ContactParameters& contact = made.scene.body_contact;
    const UnloadedStart start = half_a_kilogram(degrees, 4 * contact.stiffness, 4 * contact.damping);
    ASSERT_EQ(made.scene.bodies[1].inertia.mass, start.mass);
    const double rigid = slip(start.incline, 1);
    EXPECT_NEAR(slip(start, 1), rigid, (rigid > 0 ? 1e-3 * rigid : 1e-4) / 3) << degrees;
  }
}

}  // namespace
}  // namespace handhold::closed_form
