// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/closed_form/slider_oscillator.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold::closed_form {
namespace {

void check(const SliderOscillator& o, double until) {
  const bool finite = std::isfinite(o.mass + o.stiffness + o.damping + o.tether + o.tether_damping + until);
  if (!finite || !(o.mass > 0) || !(o.stiffness > 0) || o.damping < 0 || o.tether < 0 || o.tether_damping < 0) {
    throw InputError(
        fmt::format("slider oscillator with m = {}, K = {}, C = {}, K2 = {}, C2 = {}: m, K must be > 0, C, K2, C2 >= 0 "
                    "(check them)",
                    o.mass, o.stiffness, o.damping, o.tether, o.tether_damping));
  }
  if (o.tether == 0 && o.tether_damping > 0) {
    throw InputError(
        fmt::format("tether damping {}: a tether without spring has none (give it a stiffness)", o.tether_damping));
  }
  validate(o.friction);
}

/// A fraction of the fastest motion there is: no witness turns twice within it.
double scan_step(const SliderOscillator& o) {
  double fastest = std::sqrt((o.stiffness + o.tether) / o.mass);
  for (const Drive& drive : {o.normal_force, o.force, o.base, o.tether_end})
    if (drive.amplitude != 0) fastest = std::max(fastest, std::abs(drive.frequency));
  return 0.05 / fastest;
}

constexpr std::size_t most_events = 10000;

}  // namespace

SliderMotion::SliderMotion(const SliderOscillator& oscillator, double until, double lead)
    : o_(oscillator), lead_(lead) {
  check(o_, until);
  scan_ = scan_step(o_);
  SliderState start{.x = o_.x, .v = o_.v, .stretch = o_.stretch, .direction = o_.direction};
  double begin = 0;
  while (true) {
    phases_.push_back(phase(begin, start));
    const double end = end_of(phases_.back(), until);
    if (!(end < until)) return;
    begin = led(phases_.back(), end);
    start = state(phases_.back(), begin);
    start.direction = start.direction != 0 ? 0 : (trial(start, begin) > 0 ? 1 : -1);
    const Phase next = phase(begin, start);
    events_.push_back({begin, start.direction, state(next, begin), rate_at(phases_.back(), end)});
    if (events_.size() > most_events)
      throw InputError(fmt::format("slider oscillator: more than {} changes of mode by t = {:.6g} s (shorten the time)",
                                   most_events, begin));
  }
}

SliderMotion::Phase SliderMotion::phase(double begin, const SliderState& start) const {
  Phase phase{.begin = begin, .direction = start.direction};
  Forcing forcing;
  forcing.add(1, o_.force).add(o_.tether, o_.tether_end).add_derivative(o_.tether_damping, o_.tether_end);
  if (start.direction == 0) {
    phase.anchor = start.x - o_.base.value(begin) - start.stretch;
    forcing.add(o_.stiffness, o_.base).add_derivative(o_.damping, o_.base).add(o_.stiffness * phase.anchor);
    phase.motion = LinearMotion({o_.mass, o_.damping + o_.tether_damping, o_.stiffness + o_.tether}, forcing, begin,
                                start.x, start.v);
    return phase;
  }
  const double mu = start.direction * o_.friction.mu_dynamic;
  forcing.add(-mu, o_.normal_force);
  phase.motion = LinearMotion({o_.mass, o_.tether_damping, o_.tether}, forcing, begin, start.x, start.v);
  if (o_.damping > 0)
    phase.stretch = Relaxation(o_.damping, o_.stiffness, Forcing().add(mu, o_.normal_force), begin, start.stretch);
  return phase;
}

SliderState SliderMotion::state(const Phase& phase, double t) const {
  SliderState s{.x = phase.motion.x(t), .v = phase.motion.v(t), .direction = phase.direction};
  if (phase.direction == 0) {
    s.stretch = s.x - o_.base.value(t) - phase.anchor;
    s.friction = trial(s, t);
    return s;
  }
  s.friction = phase.direction * o_.friction.mu_dynamic * o_.normal_force.value(t);
  s.stretch = o_.damping > 0 ? phase.stretch.q(t) : s.friction / o_.stiffness;
  return s;
}

double SliderMotion::trial(const SliderState& s, double t) const {
  return o_.stiffness * s.stretch + o_.damping * (s.v - o_.base.derivative(t));
}

/// > 0: the phase is over.
double SliderMotion::witness(const Phase& phase, double t) const {
  const SliderState s = state(phase, t);
  if (phase.direction == 0) return std::abs(trial(s, t)) - o_.friction.mu_static * o_.normal_force.value(t);
  if (o_.damping > 0) return o_.friction.mu_dynamic * o_.normal_force.value(t) - phase.direction * trial(s, t);
  return o_.friction.mu_dynamic * o_.normal_force.derivative(t) / o_.stiffness -
         phase.direction * (s.v - o_.base.derivative(t));
}

/// The first root of the witness, to the last bit; `until` if there is none before.
double SliderMotion::end_of(const Phase& phase, double until) const {
  // A phase begins on the boundary of the one before it, where rounding has the say: look a little later.
  double a = phase.begin + 1e-5 * scan_;
  if (a >= until) return until;
  if (witness(phase, a) > 0) return phase.begin;
  for (double b = a; a < until; a = b) {
    b = std::min(a + scan_, until);
    if (!(witness(phase, b) > 0)) continue;
    for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b)) (witness(phase, m) > 0 ? b : a) = m;
    return b;
  }
  return until;
}

double SliderMotion::rate_at(const Phase& phase, double end) const {
  const double back = std::min(1e-3 * scan_, end - phase.begin);
  return back > 0 ? (witness(phase, end) - witness(phase, end - back)) / back : 0;
}

double SliderMotion::led(const Phase& phase, double end) const {
  if (lead_ == 0 || phase.direction != 0) return end;
  const auto slides = [&](double t) {
    return std::abs(trial(state(phase, t), t)) > o_.friction.mu_dynamic * o_.normal_force.value(t);
  };
  double a = std::max(phase.begin, end - lead_), b = end;
  if (slides(a)) return a;
  for (double m = 0.5 * (a + b); m > a && m < b; m = 0.5 * (a + b)) (slides(m) ? b : a) = m;
  return b;
}

const SliderEvent& SliderMotion::event(bool restick, int n) const {
  int left = n;
  for (const SliderEvent& e : events_)
    if ((e.direction == 0) == restick && --left == 0) return e;
  throw InputError(fmt::format("slider oscillator: has no {} number {} (ask for a longer time)",
                               restick ? "re-stick" : "breakaway", n));
}

const SliderEvent& SliderMotion::breakaway(int n) const { return event(false, n); }

const SliderEvent& SliderMotion::restick(int n) const { return event(true, n); }

SliderState SliderMotion::at(double t) const {
  auto next = std::upper_bound(phases_.begin(), phases_.end(), t, [](double s, const Phase& p) { return s < p.begin; });
  return state(next == phases_.begin() ? *next : *(next - 1), t);
}

}  // namespace handhold::closed_form
