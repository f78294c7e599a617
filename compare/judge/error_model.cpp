// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/error_model.hpp"

#include <cmath>

namespace handhold::compare {

const catalogue::Limit& limit_of(const catalogue::Claim& claim, const ErrorModel& errs) {
  return errs.kind == ErrorModel::Kind::controlled ? claim.controlled : claim.stepped;
}

double limit_value(const catalogue::Limit& limit, const ErrorModel& errs) {
  const double state =
      limit.per_accuracy * errs.accuracy + limit.per_noise * errs.noise + limit.per_rounding * errs.rounding;
  return limit.value + limit.per_step * errs.step + limit.per_delay * errs.delay +
         std::pow(errs.recovery, limit.recoveries) * state;
}

}  // namespace handhold::compare
