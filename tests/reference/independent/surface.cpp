// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/independent/surface.hpp"

#include <array>
#include <cmath>

namespace handhold::independent {
namespace {

/// Samples f_0..f_{n-1} at `stride` become coefficients: the filter 6 / (z + 4 + 1/z) as a causal and an anticausal
/// recursion with the pole √3 − 2 (Unser, IEEE Signal Processing Magazine 16(6), 1999, box 2).
void recursive_prefilter(Real* f, std::size_t stride, int n) {
  const Real pole = std::sqrt(Real(3)) - 2;
  const auto at = [&](int i) -> Real& { return f[std::size_t(i) * stride]; };
  Real first = 0, power = 1;
  for (int i = 0; i < n && std::abs(power) > 1e-22L; ++i, power *= pole) first += power * at(i);
  at(0) = first;
  for (int i = 1; i < n; ++i) at(i) += pole * at(i - 1);
  at(n - 1) = pole / (pole * pole - 1) * (at(n - 1) + pole * at(n - 2));
  for (int i = n - 2; i >= 0; --i) at(i) = pole * (at(i + 1) - at(i));
  for (int i = 0; i < n; ++i) at(i) *= 6;
}

/// β³ and its derivatives at distance x from its middle, by the definition in pieces.
std::array<Real, 3> bump(Real x) {
  const Real a = std::abs(x), sign = x < 0 ? -1 : 1;
  if (a < 1) return {Real(2) / 3 - a * a + a * a * a / 2, sign * (-2 * a + 3 * a * a / 2), -2 + 3 * a};
  if (a < 2) {
    const Real b = 2 - a;
    return {b * b * b / 6, -sign * b * b / 2, b};
  }
  return {0, 0, 0};
}

}  // namespace

Local Ball::at(const Vec3& X) const {
  const Real r = X.norm();
  const Vec3 n = X / r;
  return {r - radius_, n, (Mat3::Identity() - n * n.transpose()) / r};
}

VoxelSpline::VoxelSpline(const VoxelField& field) : grid_(field.grid()) {
  c_.assign(field.data().distance.begin(), field.data().distance.end());
  const int nx = grid_.size.x(), ny = grid_.size.y(), nz = grid_.size.z();
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j) recursive_prefilter(&c_[grid_.index(0, j, k)], 1, nx);
  for (int k = 0; k < nz; ++k)
    for (int i = 0; i < nx; ++i) recursive_prefilter(&c_[grid_.index(i, 0, k)], std::size_t(nx), ny);
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) recursive_prefilter(&c_[grid_.index(i, j, 0)], std::size_t(nx) * std::size_t(ny), nz);
}

Local VoxelSpline::at(const Vec3& X) const {
  const Vec3 u = (X - grid_.origin.cast<Real>()) / Real(grid_.spacing);
  const Eigen::Vector3i cell = u.array().floor().cast<int>();
  if ((cell.array() < 1).any() || (cell.array() + 2 >= grid_.size.array()).any())
    return {1, Vec3::UnitX(), Mat3::Zero()};  // off the grid: far away
  std::array<std::array<std::array<Real, 3>, 4>, 3> b;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 4; ++i) b[std::size_t(axis)][std::size_t(i)] = bump(u[axis] - Real(cell[axis] + i - 1));
  // along[m]: the m-th derivative in x of a row, summed; then rows with the derivatives in y and z.
  Real value = 0;
  Vec3 gradient = Vec3::Zero();
  Real xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      std::array<Real, 3> along{};
      for (int i = 0; i < 4; ++i) {
        const Real c = coefficient(cell.x() + i - 1, cell.y() + j - 1, cell.z() + k - 1);
        for (std::size_t m = 0; m < 3; ++m) along[m] += c * b[0][std::size_t(i)][m];
      }
      const auto &y = b[1][std::size_t(j)], &z = b[2][std::size_t(k)];
      value += along[0] * y[0] * z[0];
      gradient += Vec3(along[1] * y[0] * z[0], along[0] * y[1] * z[0], along[0] * y[0] * z[1]);
      xx += along[2] * y[0] * z[0];
      yy += along[0] * y[2] * z[0];
      zz += along[0] * y[0] * z[2];
      xy += along[1] * y[1] * z[0];
      xz += along[1] * y[0] * z[1];
      yz += along[0] * y[1] * z[1];
    }
  Mat3 hessian;
  hessian << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  const Real h = grid_.spacing, slope = gradient.norm();  // per node
  const Vec3 n = gradient / slope;
  const Mat3 tangential = Mat3::Identity() - n * n.transpose();
  return {value * h / slope, n, tangential * hessian * tangential / (slope * h)};
}

std::vector<std::shared_ptr<const Surface>> faces_of(const VoxelField& field) {
  std::vector<std::shared_ptr<const Surface>> faces;
  for (int axis = 0; axis < 3; ++axis) {
    faces.push_back(std::make_shared<Face>(Vec3::Unit(axis), field.bounds().max()[axis]));
    faces.push_back(std::make_shared<Face>(-Vec3::Unit(axis), -field.bounds().min()[axis]));
  }
  return faces;
}

}  // namespace handhold::independent
