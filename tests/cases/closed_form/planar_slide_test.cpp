// SPDX-License-Identifier: GPL-3.0-or-later
// The planar equation of motion (F03, F04) against closed forms of its special cases.
#include "cases/closed_form/planar_slide.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "cases/closed_form/pendulum.hpp"
#include "cases/closed_form/spin_down.hpp"

namespace handhold::closed_form {
namespace {

using Eigen::Vector2d;

constexpr double pi = std::numbers::pi;

// Rings round the centre of mass: F01's closed form, angle and stop.
TEST(PlanarSlide, SpinsDownAsTheRingsClosedForm) {
  const SpinDown spin{.stiffness = 2000};
  const double rho = lag(spin), each = spin.mu * spin.normal_force / 8;
  PlanarSlide s{.mass = 0.2, .inertia = spin.inertia, .spin = spin.spin};
  for (int i = 0; i < 8; ++i) {
    const double at = pi * i / 4;
    s.slipping.push_back({spin.radius * Vector2d{std::cos(at), std::sin(at)}, 2 * each, rho,
                          at - (pi / 2 - std::asin(rho / spin.radius))});
  }
  EXPECT_NEAR(planar_state(s, 0.1).angle, angle(spin, PatchShape::ring, 0.1), 1e-11);
  const PlanarState stop = first_restick(s, 0.4);
  EXPECT_NEAR(stop.t, stop_time(spin, PatchShape::ring), 1e-10);
  EXPECT_NEAR(stop.angle, stop_angle(spin, PatchShape::ring), 1e-10);
  EXPECT_LT(stop.center.norm(), 1e-15);
}

// All leashes along the motion, no spin: a block that brakes by μ_d N of all samples.
TEST(PlanarSlide, BrakesAsABlock) {
  PlanarSlide s{.mass = 0.3, .inertia = 1e-4, .velocity = {0.6, 0.8}};
  for (const double u : {-0.01, 0.01}) s.slipping.push_back({{u, 0}, 0.3, 1e-4, std::atan2(-0.8, -0.6)});
  const double a = 0.6 / 0.3;
  const PlanarState now = planar_state(s, 0.2);
  EXPECT_LT((now.velocity - (1 - 0.2 * a) * Vector2d(0.6, 0.8)).norm(), 1e-12);
  // The offset of the centre turns the plate: forces alike on both sides of it, though, until it has moved.
  EXPECT_NEAR(planar_state(s, 1e-3).spin, 0, 1e-3);
}

PlanarSlide hung(double stiffness, double start) {
  const double mass = 0.1, arm = 0.05, pivot_inertia = 4e-4, g = 9.81;
  const Vector2d down{-std::cos(start), -std::sin(start)}, along{std::sin(start), -std::cos(start)};
  const Vector2d load = mass * (-g * arm * arm * mass / pivot_inertia * std::sin(start) * along + Vector2d{g, 0});
  PlanarSlide s{.mass = mass, .inertia = pivot_inertia - mass * arm * arm, .gravity = {-g, 0}, .angle = start};
  s.sticking = {{.anchor_B = {arm, 0}, .stiffness = stiffness}};
  s.center = arm * down - load / stiffness;
  return s;
}

// A stiff pivot is a rigid one; what is left falls as 1/k.
TEST(PlanarSlide, SwingsAsAPendulumWhenThePivotIsStiff) {
  const double w = std::sqrt(0.1 * 9.81 * 0.05 / 4e-4), rigid = swing_from_rest(w, 1.2, 0.3);
  const double soft = planar_state(hung(1e5, 1.2), 0.3).angle - rigid;
  const double stiff = planar_state(hung(1e6, 1.2), 0.3).angle - rigid;
  EXPECT_LT(std::abs(stiff), 1e-5);
  EXPECT_NEAR(stiff / soft, 0.1, 0.002);
}

TEST(PlanarSlide, KeepsItsEnergyOnSprings) {
  const PlanarSlide s = hung(1e4, 2);
  const auto energy = [&](const PlanarState& p) {
    const Vector2d arm = 0.05 * Vector2d{std::cos(p.angle), std::sin(p.angle)};
    return 0.5 * s.mass * p.velocity.squaredNorm() + 0.5 * s.inertia * p.spin * p.spin + s.mass * 9.81 * p.center.x() +
           0.5 * 1e4 * (p.center + arm).squaredNorm();
  };
  EXPECT_NEAR(energy(planar_state(s, 0.7)), energy(planar_state(s, 0)), 1e-12);
}

// What the catalogue's cases cite as the error of their truth: a hundred times coarser steps change it by less than
// 1e-12.
TEST(PlanarSlide, HasConverged) {
  const PlanarSlide s = hung(1e4, 1.2);
  EXPECT_NEAR(planar_state(s, 0.6, 1e-11).angle, planar_state(s, 0.6).angle, 1e-12);
}

}  // namespace
}  // namespace handhold::closed_form
