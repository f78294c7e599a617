// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/judgement.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "cases/model/defect.hpp"

namespace handhold::compare {
namespace {

using Kind = catalogue::Measure::Kind;

constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();  // of a measured number: a few operations

bool is_yes_or_no(const catalogue::Claim& claim) {
  const Kind kind = claim.measure.kind;
  return kind == Kind::held || kind == Kind::no_event || kind == Kind::event_count || kind == Kind::mode_count ||
         kind == Kind::mode;
}

Grade grade_of(const catalogue::Claim& claim, double value) {
  if (is_yes_or_no(claim)) return value == claim.truth ? Grade::right : Grade::wrong;
  const double share = std::abs(value - claim.truth) / (claim.scale > 0 ? claim.scale : std::abs(claim.truth));
  if (share <= 0.001) return Grade::within_0_1_percent;
  if (share <= 0.01) return Grade::within_1_percent;
  return share <= 0.05 ? Grade::within_5_percent : Grade::wrong;  // NaN, too, is wrong
}

}  // namespace

std::string_view to_string(Grade grade) {
  switch (grade) {
    case Grade::right:
      return "right";
    case Grade::within_0_1_percent:
      return "0.1 %";
    case Grade::within_1_percent:
      return "1 %";
    case Grade::within_5_percent:
      return "5 %";
    case Grade::wrong:
      return "wrong";
  }
  return "?";
}

std::string why_not_asked(const catalogue::Claim& claim, const EngineInfo& engine) {
  const catalogue::Measure& measure = claim.measure;
  switch (measure.kind) {
    case Kind::event_time:
    case Kind::no_event:
    case Kind::event_count:
      return engine.records.events ? "" : "it records no events";
    case Kind::force:
    case Kind::torque:
    case Kind::force_sum:
    case Kind::mode_count:
    case Kind::lag:
    case Kind::work:
    case Kind::mode:
      return engine.records.contacts ? "" : "it records no contacts";
    case Kind::dissipated:
    case Kind::energy_residual:
      return engine.records.energy ? "" : "it records no energy";
    case Kind::displacement:
    case Kind::speed:
    case Kind::spin:
    case Kind::rotation:
      return measure.at || engine.records.events ? "" : "it records no events";
    case Kind::time_at_displacement:
    case Kind::held:
    case Kind::growth:
      return "";
  }
  return "";
}

Judgement judge(const catalogue::Claim& claim, const EngineInfo& engine, double value) {
  Judgement j{.engine = engine.name, .value = value};
  if (engine.errs.kind == ErrorModel::Kind::foreign) {
    j.error = std::abs(value - claim.truth);
    j.grade = grade_of(claim, value);
    return j;
  }
  const catalogue::Limit& limit = limit_of(claim, engine.errs);
  j.relative = limit.relative;
  j.error = DEFECT(relative_judged_absolute, limit.relative, false) ? std::abs(value / claim.truth - 1)
                                                                    : std::abs(value - claim.truth);
  j.gate = Gate{.quantity = fmt::format("{} error, {}", claim.quantity, engine.name),
                .measured = j.error,
                .bound = Bound::at_most,
                .limit = limit_value(limit, engine.errs),
                .unit = limit.relative ? "" : claim.unit,
                .pedigree = claim.pedigree,
                .reason = limit.reason,
                .rounding = rounding * (limit.relative ? 1 : std::abs(claim.truth))};
  return j;
}

Judgement not_asked(const EngineInfo& engine, const std::string& why) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  return {.engine = engine.name, .why_not = why, .value = nothing, .error = nothing};
}

}  // namespace handhold::compare
