// SPDX-License-Identifier: Apache-2.0
#include "cases/model/friction.hpp"

#include <cmath>

#include "cases/model/input_error.hpp"
#include "cases/model/text.hpp"

namespace handhold {

void validate(const Friction& friction) {
  const auto& [mu_static, mu_dynamic] = friction;
  if (!std::isfinite(mu_static) || !std::isfinite(mu_dynamic) || mu_static < 0 || mu_dynamic < 0) {
    throw InputError(sentence("mu_static = ", mu_static, ", mu_dynamic = ", mu_dynamic,
                              ": coefficients are finite and >= 0 (skin has 0.2 to 1)"));
  }
  if (mu_dynamic > mu_static) {
    throw InputError(sentence("mu_dynamic = ", mu_dynamic, ": must not exceed mu_static = ", mu_static,
                              " (swap them, or set both equal)"));
  }
}

}  // namespace handhold
