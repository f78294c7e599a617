#include "cases/model/rigid_surface.hpp"

#include <gtest/gtest.h>

#include "reference/rigid/contact_point.hpp"

namespace handhold::reference::rigid {
namespace {

/// Gradient and Hessian against central differences (error h² = 1e-10 times third derivatives of some 1e4/m²...
/// scaled).
TEST(RigidSurface, HasTheDerivativesOfItsDistance) {
  const Eigen::Vector3d x(0.3, -0.2, 0.45);
  for (const RigidSurface& s :
       {make_plane({0.1, 0, 0}, {1, 2, 2}), make_sphere({0, 0.1, 0}, 0.4), make_sphere({0, 0.1, 0}, 0.9, true),
        make_cylinder({0, 0, 0.1}, {1, 1, 0}, 0.3), make_cylinder({0, 0, 0.1}, {1, 0, 3}, 0.9, true)}) {
    const Proximity here = proximity(s, x);
    EXPECT_NEAR(here.normal.norm(), 1, 1e-15);
    const double h = 1e-5;
    for (int i = 0; i < 3; ++i) {
      const Proximity plus = proximity(s, x + h * Eigen::Vector3d::Unit(i));
      const Proximity minus = proximity(s, x - h * Eigen::Vector3d::Unit(i));
      EXPECT_NEAR(here.normal[i], (plus.distance - minus.distance) / (2 * h), 1e-9);
      const Eigen::Vector3d column = (plus.normal - minus.normal) / (2 * h);
      EXPECT_LT((here.curvature.col(i) - column).norm(), 1e-8);
    }
  }
}

TEST(RigidSurface, MeasuresDistancesFromItsTwoSides) {
  EXPECT_NEAR(proximity(make_sphere({0, 0, 0}, 2), {0, 0, 5}).distance, 3, 1e-15);
  EXPECT_NEAR(proximity(make_sphere({0, 0, 0}, 2, true), {0, 0, 0.5}).distance, 1.5, 1e-15);
  EXPECT_NEAR(proximity(make_cylinder({0, 0, 0}, {0, 0, 7}, 2), {3, 4, 99}).distance, 3, 1e-15);
  EXPECT_NEAR(proximity(make_plane({0, 0, 1}, {0, 0, 3}), {3, 4, 5}).distance, 4, 1e-15);
  EXPECT_TRUE(proximity(make_sphere({0, 0, 0}, 2), {0, 0, 0}).normal.isZero(0));
}

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
