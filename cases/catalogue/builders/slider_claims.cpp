// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/slider_claims.hpp"

#include <algorithm>
#include <cmath>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::SliderMotion;
using closed_form::SliderOscillator;

constexpr double step =
    1.0 / 360;  // the sub-step that the shifts are evaluated at; limits scale with the engine's own [s]
constexpr double second_order = 2;

/// What a fully implicit step of length h solves instead, to first order.
SliderOscillator stepped(SliderOscillator o, double h) {
  o.damping += h * o.stiffness;
  o.tether_damping += h * o.tether;
  o.force = o.force.advanced(h / 2);
  o.normal_force = o.normal_force.advanced(h / 2);
  o.base = o.base.advanced(-h / 2);
  o.tether_end = o.tether_end.advanced(-h / 2);
  return o;
}

const std::string source = "L2: closed form of the slider oscillator";
const std::string analysis =
    "twice the shift that backward error analysis of the implicit step gives (damping + h K, onsets up to h early, "
    "R03)";
const std::string after_stop = "; a stop before it acts up to a sub-step off";

/// An integrator's accuracy is absolute: the states of these cases are below 1 m and 1 m/s.
constexpr double noise = 10;      // accuracies
constexpr double unfelt = 1e-10;  // [m], [m/s], [s]: what an accuracy of 1e-10 leaves

/// The C2 spline through a hand sampled at 2 kHz is off by 0.05 (ω Δ)³ A ω in speed (its place, by (ω Δ)⁴ A / 384, is
/// not felt).
Limit speed_limit(const closed_form::Drive& base) {
  const double spline = 0.05 * std::pow(base.frequency / 2000, 3) * base.amplitude * base.frequency;
  return {.value = spline,
          .per_accuracy = noise,
          .reason = "ten times the integrator's accuracy; the hand's spline is off by 0.05 (w D)^3 A w"};
}

Limit state_limit() { return {.per_accuracy = noise, .reason = "ten times the integrator's accuracy"}; }

Limit time_limit(const SliderOscillator& o, const closed_form::SliderEvent& event) {
  const bool by_speed = event.direction == 0 && o.damping == 0;
  const double magnified = 1 + (by_speed ? 1 : o.stiffness + o.damping) / std::abs(event.rate);
  return {.per_accuracy = noise * magnified,
          .reason =
              "events are located to ten accuracies; ten times the integrator's accuracy in place and speed, over the "
              "rate at which the limit is crossed"};
}

}  // namespace

SliderClaims::SliderClaims(const SliderOscillator& oscillator, double until, const Eigen::Vector3d& axis, int samples)
    : o_(oscillator),
      axis_(axis),
      samples_(samples),
      truth_{SliderMotion(o_, until), 0},
      on_time_{SliderMotion(stepped(o_, step), until), step / 2},
      early_{SliderMotion(stepped(o_, step), until, step), step / 2} {}

double SliderClaims::slip_of(const View& view, double t) const {
  const closed_form::SliderState s = view.motion.at(t);
  return s.x + view.ahead * (s.v - o_.v) - o_.base.value(t) - (o_.x - o_.base.value(0));
}

double SliderClaims::speed_of(const View& view, double t) const { return view.motion.at(t).v - o_.base.derivative(t); }

/// Largest error of a stepped engine in what `read` reads, a unit of sub-step.
template <typename Read>
double SliderClaims::shift(const Read& read) const {
  const double truth = read(truth_);
  return second_order * std::max(std::abs(read(on_time_) - truth), std::abs(read(early_) - truth)) / step;
}

/// What is of second order in h when a mode changes within a step: the largest acceleration of the contact times h².
double SliderClaims::kink() const { return step * 2 * o_.friction.mu_static * o_.normal_force.value(0) / o_.mass; }

/// 1 if there is a stop before t.
double SliderClaims::stopped(double t) const {
  const auto& events = truth_.motion.events();
  return std::any_of(events.begin(), events.end(), [t](const auto& e) { return e.direction == 0 && e.t < t - 1e-9; });
}

Claim SliderClaims::event(EventKind kind, int n, const std::string& quantity) const {
  const auto of = [=](const View& view) -> const closed_form::SliderEvent& {
    return kind == EventKind::breakaway ? view.motion.breakaway(n) : view.motion.restick(n);
  };
  const auto read = [=](const View& view) { return of(view).t; };
  const double truth = read(truth_);
  return claim(quantity, truth, source, time_of(kind, 1 + (n - 1) * samples_), time_limit(o_, of(truth_)),
               {.per_step = 1.01 + stopped(truth) + shift(read),
                .reason = "shows at the end of its sub-step, + " + analysis + after_stop});
}

Claim SliderClaims::breakaway(int n, const std::string& quantity) const {
  return event(EventKind::breakaway, n, quantity);
}

Claim SliderClaims::restick(int n, const std::string& quantity) const { return event(EventKind::restick, n, quantity); }

Claim SliderClaims::slip(double t, const std::string& quantity) const {
  const auto read = [=, this](const View& view) { return slip_of(view, t); };
  const double late = stopped(t) * std::abs(speed_of(truth_, t));
  return claim(quantity, read(truth_), source, displacement_at(t, axis_), state_limit(),
               {.per_step = shift(read) + kink() + late, .reason = analysis + after_stop});
}

Claim SliderClaims::slip_at_restick(int n, const std::string& quantity) const {
  const auto read = [=, this](const View& view) { return slip_of(view, view.motion.restick(n).t); };
  return claim(quantity, read(truth_), source,
               {.kind = Measure::Kind::displacement,
                .event = EventKind::restick,
                .occurrence = 1 + (n - 1) * samples_,
                .axis = axis_},
               state_limit(), {.per_step = shift(read) + kink(), .reason = analysis});
}

Claim SliderClaims::speed(double t, const std::string& quantity) const {
  const auto read = [=, this](const View& view) { return speed_of(view, t); };
  const double late = stopped(t) * std::abs(speed_of(truth_, t) - speed_of(truth_, t - step)) / step;
  return claim(quantity, read(truth_), source, speed_at(t, axis_), speed_limit(o_.base),
               {.per_step = shift(read) + late, .reason = analysis + after_stop});
}

Curve SliderClaims::curve(const std::string& label) const {
  const SliderClaims self = *this;
  return {label, {.kind = Measure::Kind::displacement, .axis = axis_}, [self](double t) {
            return self.slip_of(self.truth_, t);
          }};
}

}  // namespace handhold::catalogue
