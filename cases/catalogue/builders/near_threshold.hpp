// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "cases/catalogue/case.hpp"

namespace handhold::catalogue {

/// A run at `share` of a threshold that asks one claim of yes or no.
[[nodiscard]] Run near_threshold(double share, std::function<Problem()> problem, Claim claim);

}  // namespace handhold::catalogue
