// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace handhold {

/// The way of a natural reach from 0 to 1: 10 τ³ − 15 τ⁴ + 6 τ⁵ (Flash & Hogan 1985), at rest before 0 and after 1.
[[nodiscard]] inline double minimum_jerk(double tau) {
  const double s = std::clamp(tau, 0.0, 1.0);
  return s * s * s * (10 + s * (-15 + 6 * s));
}

}  // namespace handhold
