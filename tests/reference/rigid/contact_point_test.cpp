// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/contact_point.hpp"

#include <gtest/gtest.h>

namespace handhold::reference::rigid {
namespace {

/// A ball that tumbles along inside a moving tube: rates against differences of the kinematics along the motion.
TEST(ContactPoint, HasTheRatesOfItsKinematics) {
  RigidSupport support;
  support.surface = make_cylinder({0, 0, 0}, {0, 1, 0.2}, 0.5, true);
  support.motion = [](double t) { return PathPoint{{t * t, 0, t}, {2 * t, 0, 1}, {2, 0, 0}}; };
  support.point_B = {0.02, -0.01, 0.03};
  support.radius = 0.05;
  const Eigen::Vector3d a(0.7, -2, 1), alpha(3, 1, -2), v(0.3, 0.1, -0.4), w(1, -2, 0.5), p(0.2, 0.1, -0.1);
  const auto motion = [&](double t) {  // to second order in t
    const Eigen::Vector3d angle = w * t + 0.5 * alpha * t * t;
    const Eigen::AngleAxisd turn(angle.norm(), angle.norm() > 0 ? Eigen::Vector3d(angle.normalized()) : w.normalized());
    return Motion{turn.toRotationMatrix(), p + v * t + 0.5 * a * t * t, w + alpha * t, v + a * t};
  };
  const double h = 1e-5;
  const ContactPoint plus = contact_point(support, h, motion(h)), minus = contact_point(support, -h, motion(-h));
  const ContactPoint here = contact_point(support, 0, motion(0));
  const ContactRates rates = contact_rates(support, 0, motion(0), a, alpha);
  EXPECT_NEAR(here.gap_rate, (plus.gap - minus.gap) / (2 * h), 1e-8);
  EXPECT_NEAR(here.gap_rate, here.normal.dot(here.velocity), 1e-14);
  EXPECT_NEAR(rates.gap_acceleration, (plus.gap_rate - minus.gap_rate) / (2 * h), 1e-7);
  EXPECT_LT((rates.acceleration - (plus.velocity - minus.velocity) / (2 * h)).norm(), 1e-7);
}

}  // namespace
}  // namespace handhold::reference::rigid
