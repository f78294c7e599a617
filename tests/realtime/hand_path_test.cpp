// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/hand_path.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace handhold::realtime {
namespace {

using Motion = std::function<Pose(double)>;

HandFrame frame(const Pose& X) {
  HandFrame f{.present = true};
  f.X_WP.fill(X);
  return f;
}

/// The path between the frames at t − dt and t, after having seen two more before.
HandPath path_to(const Motion& motion, double t, double dt) {
  HandPath path;
  for (int back = 3; back >= 0; --back) path.observe(dt, frame(motion(t - back * dt)));
  return path;
}

/// Its largest distance from the true motion between those frames.
double worst(const Motion& motion, double t, double dt) {
  const HandPath path = path_to(motion, t, dt);
  double largest = 0;
  for (int i = 0; i <= 64; ++i) {
    const double s = i / 64.0;
    largest = std::max(largest, (path.pose(palm, s).p - motion(t - dt + s * dt).p).norm());
  }
  return largest;
}

TEST(HandPath, ReproducesConstantAcceleration) {
  const Motion parabola = [](double t) { return Pose{Eigen::Quaterniond::Identity(), {t, 2 * t * t, -t * t}}; };
  EXPECT_LT(worst(parabola, 0.7, 0.01), 1e-15);  // three frames fix a parabola: rounding
}

TEST(HandPath, ErrorFallsWithTheCubeOfTheFrame) {
  const Motion sine = [](double t) { return Pose{Eigen::Quaterniond::Identity(), {std::sin(3 * t), 0, 0}}; };
  const double ratio = worst(sine, 0.7, 0.02) / worst(sine, 0.7, 0.01);
  EXPECT_NEAR(std::log2(ratio), 3, 0.1);
}

TEST(HandPath, VelocityDoesNotJumpAtAFrame) {
  const Motion sine = [](double t) {
    return Pose{Eigen::Quaterniond(Eigen::AngleAxisd(std::sin(5 * t), Eigen::Vector3d::UnitX())),
                {std::sin(7 * t), 0, 0}};
  };
  const double dt = 0.01, s = 1e-4;
  HandPath path = path_to(sine, 0.5, dt);
  const Eigen::Vector3d before = (path.pose(0, 1).p - path.pose(0, 1 - s).p) / (s * dt);
  path.observe(dt, frame(sine(0.5 + dt)));
  const Eigen::Vector3d after = (path.pose(0, s).p - path.pose(0, 0).p) / (s * dt);
  EXPECT_LT((after - before).norm(), 0.01);  // one-sided differences: s dt times the acceleration, 50 × 1e-6, twice
}

/// The axis turns as well as the angle: rates of rotation vectors of two frames are not the same thing there.
TEST(HandPath, AngularVelocityDoesNotJumpAtAFrame) {
  const Motion tumble = [](double t) {
    return Pose{Eigen::AngleAxisd(9 * t, Eigen::Vector3d::UnitX()) *
                    Eigen::Quaterniond(Eigen::AngleAxisd(std::sin(20 * t), Eigen::Vector3d::UnitY())),
                Eigen::Vector3d::Zero()};
  };
  const double dt = 0.02, s = 1e-4;
  HandPath path = path_to(tumble, 0.5, dt);
  const auto spin = [&](double from, double to) -> Eigen::Vector3d {
    return 2 * (path.pose(0, from).R.conjugate() * path.pose(0, to).R).vec() / ((to - from) * dt);
  };
  const Eigen::Vector3d before = spin(1 - s, 1);
  path.observe(dt, frame(tumble(0.5 + dt)));
  // One-sided differences, 200 rad/s² over s dt, twice, 1e-3; and the third-order series of a turn of 0.4, 1e-3 of 20.
  EXPECT_LT((spin(0, s) - before).norm(), 0.01);
}

TEST(HandPath, FollowsConstantSpinExactly) {
  const Motion spin = [](double t) {
    return Pose{Eigen::Quaterniond(Eigen::AngleAxisd(9 * t, Eigen::Vector3d(1, 2, 2) / 3)), Eigen::Vector3d::Zero()};
  };
  const HandPath path = path_to(spin, 0.4, 0.01);
  for (const double s : {0.0, 0.3, 0.9, 1.0})
    EXPECT_LT(path.pose(3, s).R.angularDistance(spin(0.39 + s * 0.01).R), 1e-7);  // acos near 1 loses half the digits
}

TEST(HandPath, MeetsEveryFrameToTheLastBit) {
  const Motion any = [](double t) {
    return Pose{Eigen::Quaterniond(Eigen::AngleAxisd(t, Eigen::Vector3d::UnitY())), {t * t, std::cos(t), 1 / (1 + t)}};
  };
  const HandPath path = path_to(any, 0.37, 0.011);
  EXPECT_EQ(path.pose(9, 1).p, any(0.37).p);
  EXPECT_EQ(path.pose(9, 1).R.coeffs(), any(0.37).R.coeffs());
}

TEST(HandPath, StandsStillAfterReappearing) {
  HandPath path = path_to([](double t) { return Pose{Eigen::Quaterniond::Identity(), {t, 0, 0}}; }, 0.1, 0.01);
  path.observe(0.01, {});
  EXPECT_FALSE(path.present());
  path.observe(0.01, frame({Eigen::Quaterniond::Identity(), {5, 0, 0}}));
  EXPECT_EQ(path.pose(0, 0.5).p.x(), 5);
}

}  // namespace
}  // namespace handhold::realtime
