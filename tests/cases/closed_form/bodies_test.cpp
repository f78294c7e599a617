// SPDX-License-Identifier: GPL-3.0-or-later
// Every formula of bodies.hpp against the law itself, integrated in small steps or put into vectors.
#include "cases/closed_form/bodies.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace handhold::closed_form {
namespace {

using Eigen::Vector3d;

constexpr double h = 1e-6;  // of leapfrog steps: off by (ω h)²/24 of a turn and less than 1e-9 here

TEST(Strike, IsWhatTwoBodiesAndASpringDo) {
  const Strike s;
  double a = 0, b = s.gap, va = s.speed_a, vb = s.speed_b, touched = -1, parted = -1, t = 0;
  for (; t < 0.35; t += h) {
    a += va * h;
    b += vb * h;
    const double force = b < a ? s.stiffness * (a - b) : 0;
    if (force > 0 && touched < 0) touched = t;
    if (force == 0 && touched > 0 && parted < 0) parted = t;
    va += h * (-force / s.mass_a - s.gravity);
    vb += h * (force / s.mass_b - s.gravity);
  }
  EXPECT_NEAR(strike_time(s), touched, 3e-6);
  EXPECT_NEAR(parting_time(s), parted, 3e-6);
  ASSERT_LT(parted, t);
  EXPECT_NEAR(speed_of_a(s, t), va, 2e-5);  // of t itself, g h
  EXPECT_NEAR(distance_of_a(s, t), a, 2e-5);
}

TEST(Bounce, IsWhatABodyOnASpringDoes) {
  const Bounce b;
  double y = b.gap, v = 0, squared = 0, events[3] = {}, t = 0;
  int n = 0;
  bool before = false;
  for (; n < 3 && t < 2; t += h) {
    y += v * h;
    const bool inside = y < 0;
    if (inside != before) events[n++] = t;
    before = inside;
    v += h * (-b.gravity + (inside ? -b.stiffness * y / b.mass : 0));
    if (inside && n == 1) squared += h * v * v;
  }
  ASSERT_EQ(n, 3);
  EXPECT_NEAR(events[0], landing_time(b), 3e-6);
  EXPECT_NEAR(events[1] - events[0], contact_time(b), 5e-6);
  EXPECT_NEAR(events[2] - events[1], flight_time(b), 5e-6);
  EXPECT_NEAR(squared / squared_speed_in_contact(b), 1, 1e-4);
}

/// Both blocks with the slider law at both interfaces (mu_s = mu_d: the lag is cut at the cone).
void play(const Stack& s, double until, double& lower, double& upper, double& first_slip, bool& pair_slipped) {
  double x[2] = {0, 0}, v[2] = {lower_start_speed(s), upper_start_speed(s)}, anchor[2] = {0, 0}, t = 0;
  const double N[2] = {(s.mass_lower + s.mass_upper) * s.gravity, s.mass_upper * s.gravity};
  const double K[2] = {s.stiffness_palm, s.stiffness_pair}, mu[2] = {s.mu_palm, s.mu_pair};
  first_slip = -1;
  while (t < until) {
    for (int i : {0, 1}) x[i] += h * v[i];
    t += h;
    const double under[2] = {s.jerk * t * t * t / 6, x[0]};
    double f[2];
    for (int i : {0, 1}) {
      f[i] = K[i] * (under[i] - x[i] - anchor[i]);
      if (std::abs(f[i]) <= mu[i] * N[i]) continue;
      if (first_slip < 0) {
        first_slip = t;
        pair_slipped = i == 1;
      }
      f[i] = std::copysign(mu[i] * N[i], f[i]);
      anchor[i] = under[i] - x[i] - f[i] / K[i];
    }
    v[0] += h * (f[0] - f[1]) / s.mass_lower;
    v[1] += h * f[1] / s.mass_upper;
  }
  lower = x[0] - s.jerk * t * t * t / 6;
  upper = x[1] - s.jerk * t * t * t / 6;
}

TEST(Stack, SlipsWhereTheSmallerFrictionIs) {
  double lower = 0, upper = 0, slip = 0;
  bool pair = false;
  const Stack above;
  play(above, 0.7, lower, upper, slip, pair);
  EXPECT_TRUE(pair);
  EXPECT_NEAR(slip, onset(above), 2e-5);
  EXPECT_NEAR(upper, upper_slip(above, 0.7), 1e-5);
  const Stack below{.mu_palm = 0.3, .mu_pair = 0.6};
  play(below, 0.5, lower, upper, slip, pair);
  EXPECT_FALSE(pair);
  EXPECT_NEAR(slip, onset(below), 2e-5);
  EXPECT_NEAR(lower, lower_slip(below, 0.5), 1e-5);
}

TEST(Sweep, EndsWhereTheArmReachesTheWall) {
  const Sweep s{.arm = 0.1, .wall = 0.09, .start = 1.2, .spin = 5};
  const double angle = s.start - s.spin * reach_time(s);
  EXPECT_NEAR(s.arm * std::cos(angle), s.wall, 1e-15);
  EXPECT_GT(angle, 0);
}

TEST(RoundSlide, KeepsTheLagOnTheConeAndTheTorqueOfItsForce) {
  const RoundSlide r{.radius = 0.03, .path_radius = 0.029};
  const double phi = trailing_angle(r);
  const Vector3d p(r.path_radius, 0, 0), n(std::cos(phi), -std::sin(phi), 0), C = r.radius * n;
  const double d = -(p - C).dot(n);
  const Vector3d e = p - C + d * n;
  EXPECT_NEAR(d, round_depth(r), 1e-17);
  EXPECT_NEAR(e.norm(), r.mu * d, 1e-16);
  EXPECT_GT(phi, 0);
  EXPECT_NEAR(C.cross(r.stiffness * (p - C)).z(), round_torque(r), 1e-14);
}

}  // namespace
}  // namespace handhold::closed_form
