// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/near_threshold.hpp"

#include <utility>

#include <fmt/format.h>

namespace handhold::catalogue {

Run near_threshold(double share, std::function<Problem()> problem, Claim claim) {
  return {
      .name = fmt::format("{} of the threshold", share), .problem = std::move(problem), .claims = {std::move(claim)}};
}

}  // namespace handhold::catalogue
