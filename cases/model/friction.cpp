#include "cases/model/friction.hpp"

#include <cmath>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold {

void validate(const Friction& friction) {
  const auto& [mu_static, mu_dynamic] = friction;
  if (!std::isfinite(mu_static) || !std::isfinite(mu_dynamic) || mu_static < 0 || mu_dynamic < 0) {
    throw InputError(
        fmt::format("mu_static = {}, mu_dynamic = {}: coefficients are finite and >= 0 (skin has 0.2 to 1)", mu_static,
                    mu_dynamic));
  }
  if (mu_dynamic > mu_static) {
    throw InputError(fmt::format("mu_dynamic = {}: must not exceed mu_static = {} (swap them, or set both equal)",
                                 mu_dynamic, mu_static));
  }
}

}  // namespace handhold
