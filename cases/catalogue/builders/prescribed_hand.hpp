// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "cases/model/scene.hpp"

namespace handhold::catalogue {

/// Sample points of one phalanx that moves as told.
struct PrescribedPatch {
  int phalanx{};
  std::vector<Eigen::Vector3d> p_P{};  ///< in the phalanx's frame [m]
  std::vector<SampleStart> start{};    ///< one a sample
  std::function<Pose(double t)> pose{};
};

/// A hand that has these patches and no other contact, sampled at `rate` [Hz] from 0.1 s before to 0.1 s after
/// [0, duration]: its splines have their knots at multiples of 1 / rate, and what they do at the ends is not felt.
[[nodiscard]] Hand prescribed_hand(const std::vector<PrescribedPatch>& patches, double duration, double rate);

}  // namespace handhold::catalogue
