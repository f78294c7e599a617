// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

namespace handhold {

/// Coulomb coefficients of a pair of surfaces, dimensionless.
struct Friction {
  double mu_static{0.5};
  double mu_dynamic{0.4};
};

/// Throws InputError unless 0 <= mu_dynamic <= mu_static < infinity.
void validate(const Friction& friction);

/// Of two surfaces that are each described by itself: the geometric mean of both coefficients (as Box2D mixes them;
/// exact when they are equal). No law of nature: give both bodies the pair's coefficients where they are known.
[[nodiscard]] inline Friction combined(const Friction& a, const Friction& b) {
  return {std::sqrt(a.mu_static * b.mu_static), std::sqrt(a.mu_dynamic * b.mu_dynamic)};
}

}  // namespace handhold
