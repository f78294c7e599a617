// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handhold::closed_form {

/// F02. Two opposite rings of samples carry a weight at distance L from the axis of the pinch, on the line through the
/// rings' first samples turned by a quarter, i.e. level. L1; L2 has the same limit to second order in lag / radius,
/// since the force of a slipping sample passes through its point on the hand.
struct EccentricLoad {
  double radius{0.004};    ///< a [m]
  double normal_force{4};  ///< N of each ring [N]
  double mu{0.5};
  double arm{0.02};  ///< L [m]
  int samples{8};    ///< of each ring, even; many: the continuous ring
};

struct LimitLoad {
  double weight{};  ///< the largest that the rings hold [N]
  double center{};  ///< distance of the centre of rotation from the axis, away from the load [m]
};

/// Upper bound theorem, exact here since Coulomb's force on samples of given N is associated: W = 2 (μN/n) min over
/// c >= 0 of Σ |r_i − c| / (L + c). Arm > 0.
[[nodiscard]] LimitLoad limit_load(const EccentricLoad& load);

}  // namespace handhold::closed_form
