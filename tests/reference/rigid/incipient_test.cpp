// SPDX-License-Identifier: GPL-3.0-or-later
// Which way a contact begins to slide, where friction and motion are askew: a foot off the centre of mass.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/reference/rigid/problems.hpp"

namespace handhold::reference::rigid {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double N = 2, mu_d = 0.2, radius = 0.01;
const Vector3d arm(0.06, 0.03, -0.05);  // from the centre of mass to the contact, under a ball

/// A body without gravity, pressed on a ball far off its centre, is pulled sideways harder than static friction allows.
RigidProblem problem() {
  RigidProblem p;
  p.mass = 1;
  p.inertia = Vector3d(2e-3, 5e-3, 4e-3).asDiagonal();
  p.gravity.setZero();
  p.duration = 0.01;
  p.supports = {{.surface = make_plane({0, 0, 0}, Vector3d::UnitZ()),
                 .normal_force = [](double) { return N; },
                 .friction = {0.5, mu_d},
                 .point_B = arm + radius * Vector3d::UnitZ(),
                 .radius = radius}};
  p.X_WB.p = -arm;
  p.load = [](double, const BodyState&) -> Load { return {.force_W = {5, 2, 0}}; };
  return p;
}

/// Acceleration of the foot by a force at the foot, and by one at the centre.
Vector3d foot_by(const RigidProblem& p, const Vector3d& at_foot, const Vector3d& at_center) {
  return (at_foot + at_center) / p.mass + (p.inertia.inverse() * arm.cross(at_foot)).cross(arm);
}

/// The angle at which the foot's acceleration is along the sliding d that friction −mu_d N d resists: by bisection of
/// their cross product, no fixed point.
double sliding_angle(const RigidProblem& p) {
  const auto askew = [&](double angle) {
    const Vector3d d(std::cos(angle), std::sin(angle), 0);
    const Vector3d a = foot_by(p, N * Vector3d::UnitZ() - mu_d * N * d, {5, 2, 0});
    return d.x() * a.y() - d.y() * a.x();
  };
  double best = 0;
  for (double from = -M_PI; from < M_PI; from += 0.01) {
    if (askew(from) * askew(from + 0.01) > 0) continue;
    double lo = from, hi = from + 0.01;
    for (int i = 0; i < 60; ++i) {
      const double mid = 0.5 * (lo + hi);
      (askew(lo) * askew(mid) <= 0 ? hi : lo) = mid;
    }
    const Vector3d d(std::cos(lo), std::sin(lo), 0);
    if (foot_by(p, N * Vector3d::UnitZ() - mu_d * N * d, {5, 2, 0}).dot(d) > 0) best = lo;
  }
  return best;
}

TEST(IncipientSlip, GoesTheWayThatItsOwnFrictionLeaves) {
  const RigidProblem p = problem();
  const Trajectory t = simulate(p);
  ASSERT_FALSE(t.frames.empty());
  const SupportState& foot = t.frames.front().supports.front();
  ASSERT_EQ(foot.mode, Mode::slip);
  const double angle = sliding_angle(p);
  EXPECT_LT((foot.friction_W + mu_d * N * Vector3d(std::cos(angle), std::sin(angle), 0)).norm(), 1e-9);
  // Friction that would hold the foot points elsewhere by far.
  Eigen::Matrix2d response;
  response.col(0) = foot_by(p, Vector3d::UnitX(), Vector3d::Zero()).head<2>();
  response.col(1) = foot_by(p, Vector3d::UnitY(), Vector3d::Zero()).head<2>();
  const Vector2d free = foot_by(p, N * Vector3d::UnitZ(), {5, 2, 0}).head<2>();
  const Vector2d holding = response.inverse() * free;
  EXPECT_GT(std::abs(std::remainder(std::atan2(holding.y(), holding.x()) - angle, 2 * M_PI)), 0.02);
}

}  // namespace
}  // namespace handhold::reference::rigid
