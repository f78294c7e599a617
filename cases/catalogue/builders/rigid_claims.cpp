// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/rigid_claims.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue::rigid {
namespace {

constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();  // of truth and measured number, relative
constexpr double after_events = 0.1;  // the short steps after events are as many as those of this much time more [s]
constexpr const char* not_derived = "no stepped engine plays L1: its limits are not derived here";

RigidClaim claim_of(const std::string& quantity, double truth, const Measure& measure, double scale = 0) {
  RigidClaim out{.claim = claim(quantity, truth, {}, measure, {}, {})};
  out.claim.scale = scale;
  return out;
}

RigidClaim yes_or_no(RigidClaim claim) {
  claim.sensitivity = 0;
  claim.stepped = exact_limit();
  return claim;
}

Limit controlled_limit(const RigidClaim& c, const StateError& error) {
  if (c.sensitivity == 0) return exact_limit();
  return {.value = rounding * std::abs(c.claim.truth),
          .per_accuracy = c.sensitivity * error.per_accuracy,
          .per_noise = c.sensitivity * error.per_noise,
          .per_rounding = c.sensitivity * error.per_rounding,
          .per_delay = c.claim.measure.kind == Measure::Kind::event_time ? 1. : 0.,
          .recoveries = c.recoveries,
          .reason = error.why + (c.why.empty() ? "" : "; " + c.why)};
}

std::string plural(EventKind kind) {
  if (kind == EventKind::touch) return "touches";
  return fmt::format("{}s", to_string(kind));
}

}  // namespace

StateError polynomial(double duration, double size) {
  return {
      .per_rounding = (duration + after_events) * size,
      .why = fmt::format("a polynomial of degree 4 at most, exact but for rounding: of states up to {}, in the steps "
                         "of {:.3g} s and those after events",
                         size, duration)};
}

StateError controlled(double magnified, const std::string& why) {
  return {.per_accuracy = 10 * magnified,
          .per_noise = magnified,
          .why = "ten times the integrator's accuracy, and the noise that is cleared away at events" +
                 (why.empty() ? why : "; " + why)};
}

RigidClaim event_time(const std::string& quantity, EventKind kind, int n, double truth, double rate, int support) {
  RigidClaim c = claim_of(quantity, truth,
                          {.kind = Measure::Kind::event_time, .event = kind, .occurrence = n, .phalanx = support});
  c.sensitivity = 1 / rate;
  c.why = fmt::format("over the rate {:.3g} at which its limit is crossed", rate);
  return c;
}

RigidClaim from_the_start(const std::string& quantity, EventKind kind) {
  return yes_or_no(claim_of(quantity, 0, time_of(kind), 1));
}

RigidClaim event_count(EventKind kind, int truth, int support) {
  const std::string of = support < 0 ? "" : fmt::format(" of contact {}", support);
  return yes_or_no(
      claim_of(plural(kind) + of, truth, {.kind = Measure::Kind::event_count, .event = kind, .phalanx = support}, 1));
}

RigidClaim way(const std::string& quantity, const Eigen::Vector3d& axis, double t, double truth, double scale) {
  return claim_of(quantity, truth, displacement_at(t, axis), scale);
}

RigidClaim way_at(const std::string& quantity, const Eigen::Vector3d& axis, EventKind kind, int n, double truth,
                  double rate, double speed) {
  RigidClaim c =
      claim_of(quantity, truth, {.kind = Measure::Kind::displacement, .event = kind, .occurrence = n, .axis = axis});
  if (rate > 0) {
    c.sensitivity = 1 + speed / rate;
    c.why = "and its speed times the event's own error";
  }
  return c;
}

RigidClaim speed(const std::string& quantity, const Eigen::Vector3d& axis, double t, double truth, double scale) {
  return claim_of(quantity, truth, catalogue::speed_at(t, axis), scale);
}

RigidClaim speed_at(const std::string& quantity, const Eigen::Vector3d& axis, EventKind kind, int n, double truth,
                    double scale) {
  return claim_of(quantity, truth, {.kind = Measure::Kind::speed, .event = kind, .occurrence = n, .axis = axis}, scale);
}

RigidClaim spin(const std::string& quantity, const Eigen::Vector3d& axis, double t, double truth, double per_state,
                double scale) {
  RigidClaim c = claim_of(quantity, truth, {.kind = Measure::Kind::spin, .axis = axis, .at = t}, scale);
  c.sensitivity = per_state;
  if (per_state != 1) c.why = fmt::format("times {:.3g} rad/m by which rolling turns its speed into spin", per_state);
  return c;
}

RigidClaim force(const std::string& quantity, int support, const Eigen::Vector3d& axis, double t, double truth,
                 Through through, double mass, double scale) {
  RigidClaim c =
      claim_of(quantity, truth, {.kind = Measure::Kind::force, .axis = axis, .at = t, .phalanx = support}, scale);
  c.sensitivity = mass;
  c.recoveries = int(through);
  c.why =
      fmt::format("times {:.3g} kg and the {}rate at which a contact recovers, by which the force follows the state",
                  mass, through == Through::gap ? "squared " : "");
  return c;
}

RigidClaim dissipated(double t, double truth, double per_state) {
  RigidClaim c = claim_of(fmt::format("heat at t = {:.4g} s", t), truth, {.kind = Measure::Kind::dissipated, .at = t});
  c.sensitivity = std::max(1.0, per_state);
  c.why = "the integrator's error in energy, or friction times that in the way";
  return c;
}

RigidClaim mode(int support, double t, Mode truth) {
  return yes_or_no(claim_of(fmt::format("mode of contact {} at t = {:.4g} s ({})", support, t, to_string(truth)),
                            double(truth), {.kind = Measure::Kind::mode, .at = t, .phalanx = support}, 1));
}

RigidClaim energy_balance(double scale) {
  return claim_of("energy out of balance", 0, {.kind = Measure::Kind::energy_residual}, scale);
}

Run run(const std::string& name, const std::function<RigidProblem()>& problem, const std::string& source,
        const StateError& error, const std::vector<RigidClaim>& claims) {
  Run out{.name = name, .problem = [problem]() -> Problem { return problem(); }};
  for (const RigidClaim& c : claims) {
    Claim claim = c.claim;
    claim.source = source;
    claim.controlled = controlled_limit(c, error);
    claim.stepped = c.stepped;
    if (claim.stepped.reason.empty()) out.not_stepped = claim.stepped.reason = not_derived;
    out.claims.push_back(claim);
  }
  return out;
}

}  // namespace handhold::catalogue::rigid
