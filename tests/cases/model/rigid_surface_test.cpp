// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/model/rigid_surface.hpp"

#include <gtest/gtest.h>

namespace handhold {
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

}  // namespace
}  // namespace handhold
