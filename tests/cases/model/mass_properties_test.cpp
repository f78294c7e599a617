// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/model/mass_properties.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "tests/cases/geometry/brute_force.hpp"

namespace handhold {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

void expect_near(const Matrix3d& actual, const Matrix3d& expected, double relative) {
  EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), relative * expected.cwiseAbs().maxCoeff())
      << actual << "\nexpected\n"
      << expected;
}

// Closed form of a cuboid: V = abc, I_x = V (b² + c²) / 12. 1e-12: the sums are long double, the inputs exact.
TEST(MassProperties, BoxHasItsClosedForm) {
  Mesh box = make_box({0.06, 0.04, 0.02});
  for (Vector3d& v : box.vertices) v += Vector3d(0.5, -0.25, 0.125);
  const SolidProperties p = solid_properties(box);
  const double volume = 0.06 * 0.04 * 0.02;
  EXPECT_NEAR(p.volume / volume, 1, 1e-12);
  EXPECT_LT((p.center - Vector3d(0.5, -0.25, 0.125)).norm(), 1e-14);
  const Vector3d squares(0.06 * 0.06, 0.04 * 0.04, 0.02 * 0.02);
  expect_near(p.inertia,
              volume / 12 *
                  Vector3d(squares.sum() - squares.x(), squares.sum() - squares.y(), squares.sum() - squares.z())
                      .asDiagonal()
                      .toDenseMatrix(),
              1e-12);
}

// A solid tetrahedron with corners 0, x, y, z at distance a: V = a³/6, centre a/4, I_xx about the corner a⁵/30, I_xy
// −a⁵/120.
TEST(MassProperties, CornerTetrahedronHasItsClosedForm) {
  const double a = 0.3;
  const Mesh tetrahedron{{{0, 0, 0}, {a, 0, 0}, {0, a, 0}, {0, 0, a}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const SolidProperties p = solid_properties(tetrahedron);
  const double volume = a * a * a / 6;
  EXPECT_NEAR(p.volume / volume, 1, 1e-12);
  EXPECT_LT((p.center - Vector3d::Constant(a / 4)).norm(), 1e-15);
  const double a5 = std::pow(a, 5);
  Matrix3d about_corner = Matrix3d::Constant(-a5 / 120);
  about_corner.diagonal().setConstant(a5 / 30);
  const Vector3d c = p.center;
  expect_near(p.inertia, about_corner - volume * (c.squaredNorm() * Matrix3d::Identity() - c * c.transpose()), 1e-12);
}

// Prism over a regular n-gon of circumradius R: V = n/2 R² sin(2π/n) h, polar second moment of the polygon
// n/2 sin(2π/n) R⁴ (2 + cos(2π/n)) / 6, so I_z = that times h; I_x = I_z/2 + V h²/12.
TEST(MassProperties, RegularPrismHasItsClosedForm) {
  const int n = 64;
  const double R = 0.03, h = 0.1, step = 2 * brute::pi / n;
  const SolidProperties p = solid_properties(make_cylinder(R, h, n));
  const double area = n / 2.0 * R * R * std::sin(step);
  const double iz = n / 2.0 * std::sin(step) * std::pow(R, 4) * (2 + std::cos(step)) / 6 * h;
  EXPECT_NEAR(p.volume / (area * h), 1, 1e-12);
  const double ix = iz / 2 + area * h * h * h / 12;
  expect_near(p.inertia, Vector3d(ix, ix, iz).asDiagonal().toDenseMatrix(), 1e-12);
}

// Inertia turns with the body: R I Rᵀ, an identity independent of the integration.
TEST(MassProperties, TurnsWithTheSolid) {
  const Mesh hammer = make_hammer();
  const SolidProperties p = solid_properties(hammer), q = solid_properties(brute::turned(hammer));
  Eigen::SelfAdjointEigenSolver<Matrix3d> own(p.inertia), turned(q.inertia);
  EXPECT_NEAR(q.volume / p.volume, 1, 1e-12);
  EXPECT_LT((own.eigenvalues() - turned.eigenvalues()).cwiseAbs().maxCoeff(), 1e-12 * own.eigenvalues().maxCoeff());
}

// A sphere's polyhedra approach 4/3 π r³ and 2/5 m r²; the error of an icosphere falls by 4 a level.
TEST(MassProperties, SpheresConverge) {
  double previous = 0;
  for (const int level : {3, 4, 5}) {
    const SolidProperties p = solid_properties(make_sphere(0.05, level));
    const double error = 1 - p.volume / (4.0 / 3 * brute::pi * std::pow(0.05, 3));
    EXPECT_GT(error, 0);
    if (previous > 0) {
      EXPECT_NEAR(previous / error, 4, 0.1);  // second order, with the next order's 2 %
    }
    previous = error;
    const double ratio = p.inertia(0, 0) / (0.4 * p.volume * 0.05 * 0.05);
    EXPECT_NEAR(ratio, 1, 2 * error);
  }
}

}  // namespace
}  // namespace handhold
