// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "cases/model/recording.hpp"
#include "cases/model/scene.hpp"
#include "reference/reference.hpp"

namespace handhold::reference::simbody {

/// The border to Simbody: reference::simulate after all input has been validated (Simbody aborts on some bad input).
[[nodiscard]] Recording simulate(const Scene& scene, const Options& options,
                                 const std::function<bool(double t)>& progress);

}  // namespace handhold::reference::simbody
