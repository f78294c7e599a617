// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/contact/element.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

namespace handhold::realtime {
namespace {

const ElementStep pressed{.stiffness = 100,
                          .damping = 0.5,
                          .h = 0.002,
                          .n = Eigen::Vector3d(0.6, 0, 0.8),
                          .reach = {-0.003, 0.001, -0.001},
                          .v_p = {0.1, -0.2, 0.05}};

TEST(Element, SplitsTheSpringAlongTheNormalAtTheAnchor) {
  ElementStep still = pressed;
  still.v_p.setZero();
  const Trial r = trial(still, Eigen::Vector3d::Zero());
  EXPECT_DOUBLE_EQ(r.depth, 0.6 * 0.003 + 0.8 * 0.001);  // d = −(p − C)·n
  EXPECT_DOUBLE_EQ(r.N, 100 * r.depth);
  EXPECT_NEAR(r.lag.dot(still.n), 0, 1e-18);
  EXPECT_NEAR((r.lag - r.depth * still.n - still.reach).norm(), 0, 1e-18);  // eq. 2 and 3: the parts make the whole
}

TEST(Element, StickingForceIsTheSpringAndDamperTowardsTheHand) {
  const Trial r = trial(pressed, Eigen::Vector3d::Zero());
  const ElementForce f = sticking_force(pressed, r);
  // Without friction's limit the element is a plain spring and damper: f = k (p − C) + c v, toward the hand, into the
  // object.
  EXPECT_NEAR((f.f - (100 * pressed.reach + 0.5 * pressed.v_p)).norm(), 0, 1e-15);
  EXPECT_LT(f.f.dot(pressed.n), 0);
}

TEST(Element, SlidingForceLiesOnTheKineticCone) {
  const double mu = 0.1;
  const Trial r = trial(pressed, Eigen::Vector3d::Zero());
  const ElementForce f = sliding_force(pressed, r, mu);
  EXPECT_NEAR(f.tangent.norm(), mu * r.N, 1e-15);
  EXPECT_NEAR(f.tangent.normalized().dot(r.t.normalized()), 1, 1e-15);
  EXPECT_NEAR(f.f.dot(pressed.n), -r.N, 1e-15);
}

TEST(Element, SlidingForceNeverExceedsTheSpring) {
  const Trial r = trial(pressed, Eigen::Vector3d::Zero());
  EXPECT_EQ(sliding_force(pressed, r, 50).f, sticking_force(pressed, r).f);
}

TEST(Element, CappedForceKeepsItsFrictionWhateverThePressure) {
  const Trial r = trial(pressed, Eigen::Vector3d::Zero());
  const ElementForce f = capped_force(pressed, r, 0.02);
  EXPECT_NEAR(f.tangent.norm(), 0.02, 1e-16);
  EXPECT_NEAR(f.f.dot(pressed.n), -r.N, 1e-15);
  // Pulled off at 3 m/s along n: nothing presses, friction stays.
  const ElementForce apart = capped_force(pressed, trial(pressed, -3 * pressed.n), 0.02);
  EXPECT_NEAR((apart.f - apart.tangent).norm(), 0, 1e-16);
  EXPECT_NEAR(apart.tangent.norm(), 0.02, 1e-16);
}

/// Force of a convex potential: its slope is symmetric, never negative, and its derivative by central differences.
TEST(Element, CappedForceFallsFromAConvexPotential) {
  const Eigen::Vector3d v{0.02, 0.01, -0.03};
  const double step = 1e-6;  // difference error ~ step^2 and rounding 1e-16 / step
  for (const double cap : {0.0, 0.02, 50.0}) {
    for (const double off : {0.0, 3.0}) {  // pressing, and pulled off
      const Eigen::Vector3d at = v - off * pressed.n;
      const ElementForce force = capped_force(pressed, trial(pressed, at), cap);
      const Eigen::Matrix3d slope = slope_of(pressed, trial(pressed, at), force.grip);
      EXPECT_NEAR((slope - slope.transpose()).norm(), 0, 1e-15);
      EXPECT_GE(slope.eigenvalues().real().minCoeff(), -1e-15);
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d dv = step * Eigen::Vector3d::Unit(i);
        const Eigen::Vector3d up = capped_force(pressed, trial(pressed, at + dv), cap).f;
        const Eigen::Vector3d down = capped_force(pressed, trial(pressed, at - dv), cap).f;
        EXPECT_NEAR(((up - down) / (2 * step) + slope.col(i)).norm(), 0, 1e-8) << cap << " " << off << " " << i;
      }
    }
  }
}

/// The derivative that Newton uses, against central differences of the force itself.
TEST(Element, SlopesAreTheDerivativesOfTheForces) {
  const Eigen::Vector3d v{0.02, 0.01, -0.03};
  const double step = 1e-6;  // difference error ~ step² f''' and rounding 1e-16 / step
  for (const double mu : {0.1, 50.0}) {
    const ElementForce at = sliding_force(pressed, trial(pressed, v), mu);
    const Eigen::Matrix3d slope = slope_of(pressed, trial(pressed, v), at.grip);
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d dv = step * Eigen::Vector3d::Unit(i);
      const Eigen::Vector3d up = sliding_force(pressed, trial(pressed, v + dv), mu).f;
      const Eigen::Vector3d down = sliding_force(pressed, trial(pressed, v - dv), mu).f;
      EXPECT_NEAR(((up - down) / (2 * step) + slope.col(i)).norm(), 0, 1e-8) << mu << " " << i;
    }
  }
}

/// What a solve moves from rest is what the law says there, to rounding.
TEST(Element, MovesItsTrialByItsVelocity) {
  const Eigen::Vector3d v{0.3, -0.2, 0.5};
  const Trial truth = trial(pressed, v);
  Trial moved;
  move_trial(pressed, trial(pressed, Eigen::Vector3d::Zero()), v, moved);
  EXPECT_NEAR(moved.N, truth.N, 1e-15);
  EXPECT_NEAR((moved.t - truth.t).norm(), 0, 1e-15);
  EXPECT_NEAR(moved.t_norm, truth.t_norm, 1e-15);
}

TEST(Element, RadialReturnKeepsForceAndLagConsistent) {
  const Eigen::Vector3d before{0.0001, 0, 0}, tangent{0.02, 0.01, 0};
  const Eigen::Vector3d e = lag_after_sliding(pressed, tangent, before);
  const Eigen::Vector3d again = pressed.stiffness * e + pressed.damping * (e - before) / pressed.h;
  EXPECT_NEAR((again - tangent).norm(), 0, 1e-16);
}

}  // namespace
}  // namespace handhold::realtime
