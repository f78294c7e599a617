// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/log/motion_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

namespace handhold::compare {

MotionFit fit_motion(const std::vector<double>& t, const std::vector<Eigen::Vector3d>& p, std::size_t begin,
                     std::size_t end, bool bent) {
  const Eigen::Index n = Eigen::Index(end - begin), terms = bent ? 3 : 2;
  double mean = 0;
  for (std::size_t i = begin; i < end; ++i) mean += t[i] / double(n);
  Eigen::MatrixXd A(n, terms);
  Eigen::MatrixX3d b(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double s = t[begin + std::size_t(i)] - mean;
    A(i, 0) = 1;
    A(i, 1) = s;
    if (bent) A(i, 2) = s * s / 2;
    b.row(i) = p[begin + std::size_t(i)].transpose();
  }
  const Eigen::MatrixX3d x = A.householderQr().solve(b);
  const Eigen::MatrixX3d r = b - A * x;
  MotionFit fit;
  fit.v = x.row(1).transpose();
  if (bent) fit.a = x.row(2).transpose();
  fit.residual = r.norm() / std::sqrt(double(n));
  const Eigen::MatrixXd covariance = (A.transpose() * A).inverse();
  const double deviation = r.colwise().norm().maxCoeff() / std::sqrt(double(std::max<Eigen::Index>(1, n - terms)));
  fit.v_error = deviation * std::sqrt(covariance(1, 1));
  if (bent) fit.a_error = deviation * std::sqrt(covariance(2, 2));
  return fit;
}

}  // namespace handhold::compare
