// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/claims.hpp"

#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {

using Eigen::Vector3d;

Measure time_of(EventKind kind, int n) { return {.kind = Measure::Kind::event_time, .event = kind, .occurrence = n}; }

Measure none_of(EventKind kind) { return {.kind = Measure::Kind::no_event, .event = kind}; }

Measure displacement_at(double t, const Vector3d& axis) {
  return {.kind = Measure::Kind::displacement, .axis = axis, .at = t};
}

Measure rotation_at(double t, const Vector3d& axis) { return {.kind = Measure::Kind::rotation, .axis = axis, .at = t}; }

Measure speed_at(double t, const Vector3d& axis) { return {.kind = Measure::Kind::speed, .axis = axis, .at = t}; }

Measure force_at(double t, const Vector3d& axis) { return {.kind = Measure::Kind::force, .axis = axis, .at = t}; }

Measure count_at(double t, Mode mode) { return {.kind = Measure::Kind::mode_count, .at = t, .mode = mode}; }

Measure displacement_when(EventKind kind, const Vector3d& axis) {
  return {.kind = Measure::Kind::displacement, .event = kind, .axis = axis};
}

Measure rotation_when(EventKind kind, const Vector3d& axis) {
  return {.kind = Measure::Kind::rotation, .event = kind, .axis = axis};
}

Claim claim(const std::string& quantity, double truth, const std::string& source, const Measure& measure,
            const Limit& controlled, const Limit& stepped, bool converges) {
  return {.quantity = quantity,
          .unit = unit_of(measure.kind),
          .truth = truth,
          .source = source,
          .measure = measure,
          .controlled = controlled,
          .stepped = stepped,
          .converges = converges};
}

Claim yes_or_no(const std::string& quantity, bool truth, const std::string& source, const Measure& measure) {
  return claim(quantity, truth ? 1 : 0, source, measure, exact_limit(), exact_limit());
}

Claim of_pedigree(Pedigree pedigree, Claim claim) {
  claim.pedigree = pedigree;
  return claim;
}

std::string unit_of(Measure::Kind kind) {
  using Kind = Measure::Kind;
  switch (kind) {
    case Kind::event_time:
    case Kind::time_at_displacement:
      return "s";
    case Kind::displacement:
    case Kind::lag:
      return "m";
    case Kind::speed:
      return "m/s";
    case Kind::spin:
      return "rad/s";
    case Kind::rotation:
      return "rad";
    case Kind::force:
    case Kind::force_sum:
      return "N";
    case Kind::torque:
      return "N m";
    case Kind::dissipated:
    case Kind::work:
    case Kind::energy_residual:
      return "J";
    case Kind::held:
    case Kind::no_event:
    case Kind::event_count:
    case Kind::mode_count:
    case Kind::growth:
    case Kind::mode:
      return "";
  }
  return "";
}

}  // namespace handhold::catalogue
