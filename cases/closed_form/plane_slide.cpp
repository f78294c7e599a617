// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/plane_slide.hpp"

#include <algorithm>
#include <cmath>

namespace handhold::closed_form {

PlaneSlide slide_from_rest(const SlideDrive& drive, double deceleration, double begin, const Eigen::Vector2d& direction,
                           double end) {
  using State = Eigen::Vector4d;
  const auto rates = [&](double t, const State& y) {
    const Eigen::Vector2d x = y.head<2>(), u = y.tail<2>();
    const Eigen::Vector2d along = u.norm() > 0 ? Eigen::Vector2d(u.normalized()) : direction;
    State rate;
    rate << u, drive(t, x, u) - deceleration * along;
    return rate;
  };
  const long steps = std::max(1L, std::lround(std::ceil((end - begin) / 1e-6)));
  const double h = (end - begin) / double(steps);
  State y = State::Zero();
  for (long i = 0; i < steps; ++i) {
    const double t = begin + double(i) * h;
    const State k1 = rates(t, y), k2 = rates(t + h / 2, y + h / 2 * k1);
    const State k3 = rates(t + h / 2, y + h / 2 * k2), k4 = rates(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return {y.head<2>(), y.tail<2>()};
}

}  // namespace handhold::closed_form
