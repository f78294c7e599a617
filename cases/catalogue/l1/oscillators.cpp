// SPDX-License-Identifier: GPL-3.0-or-later
// A block on a table, driven to and fro: L1-C05 to C09.

#include "cases/closed_form/oscillators.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "cases/catalogue/builders/rigid.hpp"
#include "cases/catalogue/builders/rigid_claims.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

namespace exact = closed_form;
using namespace rigid;
using std::numbers::pi;

/// Three half cycles, to and fro.
Run sticks_and_slips(const std::string& name, const exact::HarmonicForce& h) {
  const double half = pi / h.frequency, w = h.frequency, t1 = exact::slip_onset(h), t2 = exact::stop_time(h);
  const double onset_rate = h.force * w * std::cos(w * t1) / h.mass;
  const double stop_rate = std::abs(h.friction.mu_dynamic * h.gravity - h.force / h.mass * std::sin(w * t2));
  const double end = 2 * half + t2 + 0.01 * half;
  std::vector<RigidClaim> claims;
  for (int k = 0; k < 3; ++k) {
    const std::string n = fmt::format(" {}", k + 1);
    claims.push_back(event_time("slip onset" + n, EventKind::breakaway, k + 1, t1 + k * half, onset_rate));
    claims.push_back(event_time("stop" + n, EventKind::restick, k + 1, t2 + k * half, stop_rate));
    RigidClaim at_stop = way_at("slip at stop" + n, x_axis, EventKind::restick, k + 1, k == 1 ? 0 : exact::slip(h));
    at_stop.claim.scale = exact::slip(h);
    claims.push_back(at_stop);
  }
  claims.push_back(event_count(EventKind::breakaway, 3));
  claims.push_back(energy_balance(0.1));
  return run(
      name,
      [=] {
        RigidProblem p = block(h.mass, h.friction, end);
        p.load = [=](double t, const BodyState&) { return Load{h.force * std::sin(w * t) * x_axis, {0, 0, 0}}; };
        return p;
      },
      "L1: t1 = asin(mu_s m g / F0) / w, t2 the zero of F0/(m w) (cos wt1 - cos wt) - mu_d g (t - t1)", controlled(),
      claims);
}

Case harmonic_force() {
  return {.id = "L1-C05",
          .title = "Harmonic force: stick-slip",
          .statement = "A block on a table under a force F0 sin(w t): it slips once in every half cycle.",
          .formula = "t1 = asin(mu_s m g / F0) / w",
          .runs = {sticks_and_slips("10 rad/s", {0.2, 1.4, 10, g, {0.5, 0.4}}),
                   sticks_and_slips("one coefficient", {0.2, 1.4, 10, g, {0.5, 0.5}}),
                   sticks_and_slips("40 rad/s", {0.1, 0.6, 40, g, {0.6, 0.45}})}};
}

Run decays(const std::string& name, const exact::FrictionOscillator& o) {
  const int n = exact::half_swings(o);
  const double end = 0.3 + exact::stop_time(o);
  std::vector<RigidClaim> claims{from_the_start("slip onset", EventKind::breakaway)};
  for (int j = 1; j <= n; ++j) {
    const double x = exact::turning_point(o, j);
    // An error of the place swings into a speed of w times it, which shifts the stop.
    const double rate = (o.stiffness * std::abs(x) / o.mass + o.friction.mu_dynamic * o.gravity) /
                        std::max(1.0, std::sqrt(o.stiffness / o.mass));
    claims.push_back(event_time(fmt::format("stop {}", j), EventKind::restick, j, exact::stop_time(o) * j / n, rate));
    claims.push_back(way_at(fmt::format("way to stop {}", j), x_axis, EventKind::restick, j, x - o.start));
  }
  claims.push_back(way("way at the end", x_axis, end, exact::turning_point(o, n) - o.start));
  claims.push_back(event_count(EventKind::restick, n));
  claims.push_back(event_count(EventKind::breakaway, n));
  claims.push_back(mode(0, end, Mode::stick));
  claims.push_back(energy_balance(0.25));
  return run(
      name, [=] { return sprung_block(o.mass, o.stiffness, o.friction, o.start, end); },
      "L1: x_j = (-1)^j (x0 - 2 j mu_d m g / k) at j pi sqrt(m / k) (Lorenz 1924)", controlled(), claims);
}

Case friction_oscillator() {
  return {.id = "L1-C06",
          .title = "Free oscillator with Coulomb friction",
          .statement = "A block on a spring is let go; its turning points come nearer by equal steps until it stays.",
          .formula = "x_j = (-1)^j (x0 - 2 j mu_d m g / k)",
          .runs = {decays("let go at 0.1 m", {0.2, 50, 0.1, g, {0.5, 0.4}}),
                   decays("let go at 0.173 m, one coefficient", {0.2, 50, 0.173, g, {0.4, 0.4}})}};
}

/// Five cycles from a start on the orbit. The orbit attracts, so errors do not add up.
Run shaken(const std::string& name, const exact::DenHartog& d) {
  const double half = pi / d.frequency, X = exact::amplitude(d), end = 10.3 * half;
  const double rubs = d.mu * d.mass * d.gravity;
  const double rate = std::abs(-d.force * std::cos(exact::phase(d)) + d.stiffness * X + rubs) / d.mass;
  std::vector<RigidClaim> claims{from_the_start("slip onset", EventKind::breakaway)};
  for (const int k : {1, 2, 9, 10}) {
    RigidClaim turn = way_at(fmt::format("way to turn {}", k), x_axis, EventKind::restick, k, k % 2 == 0 ? 0 : -2 * X);
    turn.claim.scale = X;
    claims.push_back(event_time(fmt::format("turn {}", k), EventKind::restick, k, k * half, rate));
    claims.push_back(turn);
  }
  for (const int k : {10, 50, 100})
    if (k / 90. < end)
      claims.push_back(way(fmt::format("way on frame {}", k), x_axis, k / 90., exact::position(d, k / 90.) - X, X));
  claims.push_back(event_count(EventKind::restick, 10));
  claims.push_back(event_count(EventKind::breakaway, 11));
  claims.push_back(
      dissipated(end, 5 * exact::dissipation(d) + rubs * (X - exact::position(d, 10 * half + 0.3 * half)), rubs));
  claims.push_back(energy_balance(exact::dissipation(d)));
  Run out = run(
      name,
      [=] {
        RigidProblem p = sprung_block(d.mass, d.stiffness, {d.mu, d.mu}, X, end);
        p.load = [=](double t, const BodyState&) {
          return Load{d.force * std::cos(d.frequency * t + exact::phase(d)) * x_axis, {0, 0, 0}};
        };
        return p;
      },
      "L1: X = sqrt((F0/k / (1 - w^2/wn^2))^2 - (f U)^2) (Den Hartog 1931)", controlled(), claims);
  out.curve = Curve{"way [m]", {.kind = Measure::Kind::displacement, .axis = x_axis}, [=](double t) {
                      return exact::position(d, t) - X;
                    }};
  return out;
}

Case forced_oscillator() {
  return {.id = "L1-C07",
          .title = "Den Hartog's forced oscillator",
          .statement = "A block on a spring under a harmonic force, in its steady motion without stops.",
          .formula = "X = sqrt((F0/k / (1 - w^2/wn^2))^2 - (f U)^2)",
          .runs = {shaken("10 rad/s", {0.2, 50, 1, 10, 0.2, g}), shaken("25 rad/s", {0.2, 50, 1, 25, 0.1, g})}};
}

Run on_belt(const std::string& name, const exact::BeltOscillator& b) {
  const double stick = exact::stick_time(b), period = stick + exact::slip_time(b), start = exact::restick_position(b);
  const double swing = exact::greatest_position(b) - exact::least_position(b);
  // An error of the place swings into a speed of w times it, which shifts the stop, and with it the next onset.
  const double stop_rate =
      (b.friction.mu_static - b.friction.mu_dynamic) * b.gravity / std::max(1.0, std::sqrt(b.stiffness / b.mass));
  const double onset_rate = 1 / (1 / stop_rate + b.mass / (b.stiffness * b.speed));
  std::vector<RigidClaim> claims;
  for (int k = 0; k < 3; ++k) {
    const std::string n = fmt::format(" {}", k + 1);
    claims.push_back(event_time("slip onset" + n, EventKind::breakaway, k + 1, k * period + stick, onset_rate));
    claims.push_back(event_time("re-stick" + n, EventKind::restick, k + 1, (k + 1) * period, stop_rate));
    claims.push_back(way_at("way on the belt at re-stick" + n, x_axis, EventKind::restick, k + 1,
                            -b.speed * (k + 1) * period, stop_rate, b.speed));
  }
  const int last = int(90 * period);
  for (const int k : {last / 2, last})
    claims.push_back(way(fmt::format("way on the belt on frame {}", k), x_axis, k / 90.,
                         exact::position(b, k / 90.) - start - b.speed * k / 90, swing));
  claims.push_back(event_count(EventKind::restick, 3));
  claims.push_back(event_count(EventKind::breakaway, 3));
  claims.push_back(energy_balance(0.01));
  return run(
      name,
      [=] {
        RigidProblem p = sprung_block(b.mass, b.stiffness, b.friction, start, 3.2 * period);
        p.V_WB.v = b.speed * x_axis;
        p.supports[0].motion = steady(b.speed * x_axis);
        return p;
      },
      "L1: sticks for 2 D / V, slips for (2/wn) (pi - atan(wn D / V)), D = (mu_s - mu_d) m g / k", controlled(),
      claims);
}

Case belt() {
  return {.id = "L1-C08",
          .title = "Block on a belt",
          .statement = "A block on a spring stands on a moving belt: stick-slip on its limit cycle.",
          .formula = "period 2 D / V + (2/wn) (pi - atan(wn D / V)), D = (mu_s - mu_d) m g / k",
          .runs = {on_belt("5 cm/s", {0.2, 50, 0.05, g, {0.6, 0.4}}),
                   on_belt("1 cm/s, a swing of 0.3 mm", {0.05, 800, 0.01, g, {0.5, 0.3}})}};
}

Run on_palm(const std::string& name, const exact::OscillatingPalm& palm) {
  const double half = pi / palm.frequency, v = exact::peak_speed(palm), phase = exact::switching_phase(palm);
  const double slip = exact::slip_per_cycle(palm) / 2;
  const double rate = palm.mu * palm.gravity + palm.amplitude * palm.frequency * palm.frequency * std::sin(phase);
  std::vector<RigidClaim> claims{from_the_start("slip onset", EventKind::breakaway)};
  for (const int k : {1, 2, 5, 6}) {
    RigidClaim turn =
        way_at(fmt::format("way on the palm at turn {}", k), x_axis, EventKind::restick, k, k % 2 == 0 ? 0 : slip);
    turn.claim.scale = slip;
    claims.push_back(event_time(fmt::format("turn {}", k), EventKind::restick, k, k * half, rate));
    claims.push_back(turn);
  }
  claims.push_back(event_count(EventKind::restick, 6));
  claims.push_back(event_count(EventKind::breakaway, 7));
  claims.push_back(energy_balance(0.1));
  return run(
      name,
      [=] {
        RigidProblem p = block(0.2, {palm.mu, palm.mu}, 6.3 * half);
        p.supports[0].motion = sine(x_axis, palm.amplitude, palm.frequency, phase);
        p.V_WB.v = v * x_axis;
        return p;
      },
      "L1: a triangle wave of speed, peak pi mu g / (2 w); turns every half cycle", controlled(), claims);
}

/// Below the limit it goes with the palm.
Run goes_with_palm() {
  const exact::OscillatingPalm palm{0.05, 9, 0.6, g};
  const double m = 0.2, w = palm.frequency;
  std::vector<RigidClaim> claims{event_count(EventKind::breakaway, 0), way("way on the palm", x_axis, 1, 0, 0.05),
                                 mode(0, 1, exact::sticks(palm) ? Mode::stick : Mode::slip), energy_balance(0.1)};
  for (const int k : {20, 70})
    claims.push_back(force(fmt::format("friction on frame {}", k), 0, x_axis, k / 90.,
                           -m * palm.amplitude * w * w * std::sin(w * k / 90.), Through::sliding_speed, m, 0.2));
  return run(
      "sticks",
      [=] {
        RigidProblem p = block(m, {palm.mu, palm.mu}, 1);
        p.supports[0].motion = sine(x_axis, palm.amplitude, w);
        p.V_WB.v = exact::peak_speed(palm) * x_axis;
        return p;
      },
      "L1: sticks iff A w^2 <= mu g; friction m x''", controlled(), claims);
}

Case oscillating_palm() {
  return {.id = "L1-C09",
          .title = "Horizontally oscillating palm",
          .statement = "A block lies on a palm that moves as A sin(w t): it slides throughout, or goes along.",
          .formula = "slides throughout iff (A w^2)^2 >= (mu g)^2 (1 + pi^2/4)",
          .runs = {on_palm("20 rad/s", {0.05, 20, 0.4, g}), on_palm("50 rad/s", {0.02, 50, 0.5, g}), goes_with_palm()}};
}

}  // namespace

std::vector<Case> rigid_oscillators() {
  return {harmonic_force(), friction_oscillator(), forced_oscillator(), belt(), oscillating_palm()};
}

}  // namespace handhold::catalogue
