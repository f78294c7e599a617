// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/order_study.hpp"

#include <cmath>

#include <fmt/format.h>

namespace handhold::compare {
namespace {

/// First order is claimed wherever nothing switches; 0.1 is the band that the claim is tested to.
constexpr double order_band = 0.1;

}  // namespace

void conclude(OrderStudy& study, const catalogue::Claim& claim) {
  study.order = observed_order(study.step, study.error);
  study.gate = {.quantity = fmt::format("{}, |order − 1|, {}", claim.quantity, study.engine),
                .measured = std::abs(study.order.slope - 1),
                .limit = order_band,
                .pedigree = claim.pedigree,
                .reason = "a fully implicit first-order step: halving it halves the error"};
}

}  // namespace handhold::compare
