// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace handhold::closed_form {

/// Serves the times of curved_slide.hpp and tops.hpp: ∫ f from a to b by Gauss and Legendre's rule with 128 nodes:
/// round-off for functions that are analytic well around the interval.
[[nodiscard]] double gauss_legendre(const std::function<double(double)>& f, double a, double b);

}  // namespace handhold::closed_form
