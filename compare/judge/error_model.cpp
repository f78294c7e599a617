// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/error_model.hpp"

namespace handhold::compare {

const catalogue::Limit& limit_of(const catalogue::Claim& claim, const ErrorModel& errs) {
  return errs.kind == ErrorModel::Kind::controlled ? claim.controlled : claim.stepped;
}

double limit_value(const catalogue::Limit& limit, const ErrorModel& errs) {
  return limit.value + limit.per_accuracy * errs.accuracy + limit.per_step * errs.step;
}

}  // namespace handhold::compare
