// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/model/scene.hpp"

namespace handhold::reference {

/// The times within a scene at which hands come and go and supports let go, ascending [s].
[[nodiscard]] std::vector<double> breaks_of(const Scene& scene);

}  // namespace handhold::reference
