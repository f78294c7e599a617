// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/spline_surface.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"
#include "tests/reference/fields.hpp"

namespace handhold::reference {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Node distances of this plane are multiples of 2^-15 m, exact as floats. The clamp of the band is 50 voxels away:
// 0.27^50.
TEST(SplineSurface, IsExactForAPlane) {
  const Vector3d slope(0.25, -0.5, 1);
  const auto plane = [&](const Vector3d& p) { return slope.dot(p) - 0.03125 / 4; };
  const SplineSurface surface(testing::field_of(plane, 1.0 / 64, 1.0 / 1024, 1.0 / 16));
  for (const Vector3d& p :
       {Vector3d(0.001, 0.002, 0.003), Vector3d(-0.0101, 0.0099, 0.0007), Vector3d(0, 0.0200001, 0)}) {
    const SurfaceSample s = surface.evaluate(p);
    EXPECT_NEAR(s.value, plane(p), 1e-16);          // a few ulp of coefficients of size 0.05
    EXPECT_LT((s.gradient - slope).norm(), 1e-12);  // ... over h
    EXPECT_LT(s.hessian.norm(), 1e-8);              // ... over h²
    EXPECT_NEAR(surface.value(p), s.value, 1e-17);
    EXPECT_NEAR(plane(surface.project(p)), 0, 1e-16);
  }
}

double sphere_error(double h) {
  const double radius = 0.02;
  const auto sphere = [&](const Vector3d& p) { return p.norm() - radius; };
  const SplineSurface surface(testing::field_of(sphere, 1.0 / 32, h, 1.0 / 64));
  double worst = 0;
  for (int i = 0; i < 200; ++i) {
    const double z = -1 + (2 * i + 1) / 200.0, turn = 2.4 * i;  // spread over the sphere
    const double s = std::sqrt(1 - z * z);
    const Vector3d p = radius * Vector3d(s * std::cos(turn), s * std::sin(turn), z);
    worst = std::max(worst, std::abs(surface.value(p)));
  }
  return worst;
}

// Cubic splines interpolate a smooth function to O(h⁴) (de Boor 1978). Coarse voxels, so that float distances (1e-9 m)
// do not show; the 12-voxel rule sets h <= 1/64/12.
TEST(SplineSurface, IsOfOrderFourOnASphere) {
  const double coarse = sphere_error(1.0 / 768), fine = sphere_error(1.0 / 1536);
  EXPECT_GT(std::log2(coarse / fine), 3.7);
  EXPECT_LT(coarse, 2e-7);
}

TEST(SplineSurface, DerivativesAgreeWithDifferences) {
  const auto sphere = [](const Vector3d& p) { return p.norm() - 0.02; };
  const SplineSurface surface(testing::field_of(sphere, 1.0 / 32, 1.0 / 1024, 1.0 / 64));
  const Vector3d p(0.011, -0.013, 0.0101);
  const SurfaceSample s = surface.evaluate(p);
  const double step = 1e-6;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d e = step * Vector3d::Unit(axis);
    // Central differences: h² f'''/6 ~ 1e-12 * 1e3, and round-off 1e-17 / h.
    EXPECT_NEAR((surface.value(p + e) - surface.value(p - e)) / (2 * step), s.gradient[axis], 1e-8);
    const Vector3d column = (surface.gradient(p + e).gradient - surface.gradient(p - e).gradient) / (2 * step);
    EXPECT_LT((column - s.hessian.col(axis)).norm(), 1e-3);  // of 50 /m
  }
  const Matrix3d exact = (Matrix3d::Identity() - p * p.transpose() / p.squaredNorm()) / p.norm();
  EXPECT_LT((s.hessian - exact).norm(), 0.5);  // order 2 in h, and 1e-9 m of float over h²; of 70 /m
}

// The point of a box below a point 5 mm inside lies straight below it, and the remainder is along the normal.
TEST(SplineSurface, FindsTheFootOfADeepPoint) {
  const SplineSurface surface(voxelize(make_box(Vector3d::Constant(1.0 / 16)), {1.0 / 1024, 0}));
  const Vector3d p(0.003, -0.002, -1.0 / 32 + 0.005);
  const Foot foot = surface.foot(p);
  // Exact float distances; edges 28 voxels away are felt by 0.27^28.
  EXPECT_LT((foot.p_O - Vector3d(0.003, -0.002, -1.0 / 32)).norm(), 1e-12);
  EXPECT_LT((foot.n_O + Vector3d::UnitZ()).norm(), 1e-10);
  EXPECT_NEAR(foot.depth, 0.005, 1e-12);
  const Vector3d r = p - foot.p_O;
  EXPECT_LT((r + foot.depth * foot.n_O).norm(), 1e-15);
}

TEST(SplineSurface, IsPositiveOffTheGrid) {
  const SplineSurface surface(voxelize(make_box(Vector3d::Constant(1.0 / 16)), {1.0 / 1024, 0}));
  EXPECT_GT(surface.value({1, 0, 0}), 0.9);
  EXPECT_GT(surface.value({0, 0, -0.06}), 0);
}

TEST(SplineSurface, RejectsANarrowBand) {
  EXPECT_THROW(SplineSurface(voxelize(make_box(Vector3d::Constant(1.0 / 16)), {1.0 / 1024, 8.0 / 1024})), InputError);
}

}  // namespace
}  // namespace handhold::reference
