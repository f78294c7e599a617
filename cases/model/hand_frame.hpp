// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "cases/model/hand_model.hpp"
#include "cases/model/pose.hpp"

namespace handhold {

/// One hand at one frame: all that an engine which steps with a tracker ever sees of it.
struct HandFrame {
  bool present{false};
  std::array<Pose, phalanx_count> X_WP{};
};

}  // namespace handhold
