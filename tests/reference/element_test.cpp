// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/element.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace handhold::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double radius = 0.03;  // [m]

AnchorSurface sphere_at(const Vector3d& anchor) {
  const Vector3d n = anchor.normalized();
  return {anchor.norm() - radius, n, (Matrix3d::Identity() - n * n.transpose()) / anchor.norm()};
}

/// A point `depth` below the anchor, `lag` beside it.
Vector3d point_below(const Vector3d& anchor, double depth, const Vector3d& lag) {
  return anchor - depth * anchor.normalized() + lag;
}

// |e| − mu_d d must not change when p moves with v and C with the rate that the element gives it. Central difference on
// an exact sphere.
TEST(SpringSlip, KeepsTheLagOnTheConeOnASphere) {
  const Element element{400, 0, {0.5, 0.4}};
  const Vector3d anchor(0, 0, radius), lag(0.4 * 0.004, 0, 0);
  const Vector3d p = point_below(anchor, 0.004, lag);
  const Vector3d v(0.3, 0.2, -0.1);
  const Response now = respond(element, Mode::slip, {p - anchor, v}, sphere_at(anchor));
  ASSERT_FALSE(now.singular);
  const auto off_cone = [&](double dt) {
    const Vector3d a = radius * (anchor + dt * now.anchor_rate).normalized();
    const Response r = respond(element, Mode::slip, {p + dt * v - a, v}, sphere_at(a));
    return r.lag.norm() - 0.4 * r.depth;
  };
  EXPECT_NEAR(off_cone(0), 0, 1e-17);
  EXPECT_NEAR((off_cone(1e-6) - off_cone(-1e-6)) / 2e-6, 0, 1e-9);  // second order: dt² / R² of 0.3 m/s
  EXPECT_NEAR(now.friction, -now.anchor_rate.norm(), 1e-12);        // slides on: lambda > 0
}

TEST(SpringSlip, HasNoSolutionRoundASharpEdge) {
  const Element element{400, 0, {0.5, 0.4}};
  const Vector3d anchor(0, 0, radius), p = point_below(anchor, 0.028, {0.4 * 0.028, 0, 0});  // d (1 + mu²) > R
  EXPECT_TRUE(respond(element, Mode::slip, {p - anchor, {1, 0, 0}}, sphere_at(anchor)).singular);
}

// The force of slip is Coulomb's and along t*; what is neither stored nor passed on is dissipated: f·v = dE/dt +
// dissipation, with dE/dt = k r·(v_C − C').
TEST(DampedSlip, IsCoulombAndBalancesPower) {
  const Element element{400, 0.5, {0.5, 0.4}};
  const Vector3d anchor(0, 0, radius), r = point_below(anchor, 0.003, {0.002, 0.001, 0}) - anchor;
  const Vector3d v(0.2, -0.3, -0.05);
  const Response now = respond(element, Mode::slip, {r, v}, sphere_at(anchor));
  const Vector3d n = anchor.normalized();
  EXPECT_NEAR(now.normal_force, 400 * 0.003 + 0.5 * 0.05, 1e-12);
  const Vector3d tangent = now.force + now.normal_force * n;
  EXPECT_NEAR(tangent.norm(), 0.4 * now.normal_force, 1e-12);
  EXPECT_NEAR(tangent.cross(now.trial).norm(), 0, 1e-12);
  EXPECT_NEAR(now.force.dot(v), 400 * r.dot(v - now.anchor_rate) + now.dissipation, 1e-12);
  EXPECT_GT(now.dissipation, 0);
}

TEST(Stick, IsASpringAndADamper) {
  const Element element{400, 0.5, {0.5, 0.4}};
  const Vector3d anchor(0, 0, radius), r(0.0003, 0, -0.003), v(0.1, -0.2, 0.3);
  const Response now = respond(element, Mode::stick, {r, v}, sphere_at(anchor));
  EXPECT_LT((now.force - (400 * r + 0.5 * v)).norm(), 1e-13);
  EXPECT_EQ(now.anchor_rate, Vector3d(0, 0, 0));
  EXPECT_NEAR(now.force.dot(v), 400 * r.dot(v) + now.dissipation, 1e-13);
}

// Without friction the anchor stays below the point: p at depth d on a sphere, moving round it, has its foot move by
// R/(R − d).
TEST(Frictionless, KeepsTheAnchorBelowThePoint) {
  const Element element{400, 0, {0, 0}};
  const Vector3d anchor(0, 0, radius), p = point_below(anchor, 0.006, {0, 0, 0}), v(0.3, 0, 0);
  const Response now = respond(element, Mode::slip, {p - anchor, v}, sphere_at(anchor));
  EXPECT_LT((now.anchor_rate - v * radius / (radius - 0.006)).norm(), 1e-12);
  EXPECT_LT((now.force + 400 * 0.006 * Vector3d::UnitZ()).norm(), 1e-12);
}

}  // namespace
}  // namespace handhold::reference
