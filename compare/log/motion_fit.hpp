// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace handhold::compare {

/// Least squares p(t) = p0 + v (t - tm) + a (t - tm)²/2 over some frames, tm their mean time.
struct MotionFit {
  Eigen::Vector3d v{Eigen::Vector3d::Zero()};  ///< [m/s]
  Eigen::Vector3d a{Eigen::Vector3d::Zero()};  ///< [m/s²]; zero for a straight fit
  double v_error{}, a_error{};                 ///< standard errors, the largest of the three axes
  double residual{};                           ///< rms distance of a frame from the fit [m]
};

/// Of frames [begin, end), at least five. `bent` false: a = 0.
[[nodiscard]] MotionFit fit_motion(const std::vector<double>& t, const std::vector<Eigen::Vector3d>& p,
                                   std::size_t begin, std::size_t end, bool bent);

}  // namespace handhold::compare
