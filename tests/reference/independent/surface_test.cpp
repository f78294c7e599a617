// SPDX-License-Identifier: GPL-3.0-or-later
// The independent solver's own spline: against the exact sphere whose distances it was given, and its derivatives
// against differences of itself.

#include "tests/reference/independent/surface.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/certification_scenes.hpp"

namespace handhold::independent {
namespace {

const Vec3 near_surface = Real(0.0297L) * Vec3(0.3L, -0.9L, 0.4L).normalized();

TEST(VoxelSpline, IsTheSphereToFourthOrder) {
  const Scene scene = catalogue::certification_scene("ball").scene();
  const VoxelSpline spline(*scene.bodies.front().field);
  const Ball sphere(0.03L);
  const Local a = spline.at(near_surface), b = sphere.at(near_surface);
  // h^4 / (384 R^3) ~ 1e-10 m and float round-off of 3e-4 m, 3e-11 m at a node, 1e-10 m over a stencil; the first and
  // second derivative lose one and two powers of h = 1e-3 m.
  EXPECT_NEAR(double(a.phi), double(b.phi), 1e-9);
  EXPECT_LT(double((a.n - b.n).norm()), 1e-6);
  EXPECT_LT(double((a.shape - b.shape).norm()), 1e-2);  // of 47 / m
}

TEST(VoxelSpline, TurnsItsNormalAsItsShapeSays) {
  const Scene scene = catalogue::certification_scene("ball").scene();
  const VoxelSpline spline(*scene.bodies.front().field);
  const Local at = spline.at(near_surface);
  const Vec3 along = at.n.unitOrthogonal();
  const Real step = 1e-7L;  // central difference: step² / R² of the curvature, and 1e-19 / step of round-off
  const Vec3 turned =
      (spline.at(near_surface + step * along).n - spline.at(near_surface - step * along).n) / (2 * step);
  EXPECT_LT(double((turned - at.shape * along).norm()), 1e-7);
}

}  // namespace
}  // namespace handhold::independent
