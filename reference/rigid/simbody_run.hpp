// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/rigid/rigid.hpp"

namespace handhold::reference::rigid::simbody {

/// The border to Simbody: rigid::simulate after all input has been validated (Simbody aborts on some bad input).
[[nodiscard]] Trajectory simulate(const RigidProblem& problem, const Options& options,
                                  const std::function<bool(double t)>& progress);

}  // namespace handhold::reference::rigid::simbody
