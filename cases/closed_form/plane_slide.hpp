// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <Eigen/Core>

namespace handhold::closed_form {

/// Serves D06 (moved_pinch.hpp) and C12 (turning_palm.hpp). A small object that slides on a plane: x' = u, u' = a(t, x,
/// u) − c u/|u|. L1, c = μ_d N/m constant.
struct PlaneSlide {
  Eigen::Vector2d x{Eigen::Vector2d::Zero()};  ///< since the slide began [m]
  Eigen::Vector2d u{Eigen::Vector2d::Zero()};  ///< [m/s]
};

/// a(t, x, u) [m/s²].
using SlideDrive = std::function<Eigen::Vector2d(double t, const Eigen::Vector2d& x, const Eigen::Vector2d& u)>;

/// At `end`, from rest at `begin`, sliding first along `direction` (unit, that of a there; |a| > c). By Runge and
/// Kutta's fixed steps of a microsecond: pedigree converged. Valid up to the stop.
[[nodiscard]] PlaneSlide slide_from_rest(const SlideDrive& drive, double deceleration, double begin,
                                         const Eigen::Vector2d& direction, double end);

}  // namespace handhold::closed_form
