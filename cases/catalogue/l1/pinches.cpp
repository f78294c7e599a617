// SPDX-License-Identifier: GPL-3.0-or-later
// A body held by fingers that press: L1-D01 to D04, D06.

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/rigid.hpp"
#include "cases/catalogue/builders/rigid_claims.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/moved_pinch.hpp"
#include "cases/closed_form/pinch.hpp"

namespace handhold::catalogue {
namespace {

namespace exact = closed_form;
using namespace rigid;
using std::numbers::pi;

Run lifted(const exact::Pinch& pinch) {
  const double end = 0.1;
  const bool holds = exact::holds(pinch);
  const double share =
      holds ? pinch.mass * (g + pinch.acceleration) / pinch.fingers : pinch.friction.mu_dynamic * pinch.normal_force;
  std::vector<RigidClaim> claims{way("slip in the hand", z_axis, end, -exact::slip(pinch, end), 0.01),
                                 event_count(EventKind::breakaway, holds ? 0 : pinch.fingers), energy_balance(0.01)};
  for (int i = 0; i < pinch.fingers; ++i) {
    claims.push_back(mode(i, end, holds ? Mode::stick : Mode::slip));
    claims.push_back(
        force(fmt::format("friction of finger {}", i), i, z_axis, end, share, Through::sliding_speed, pinch.mass));
  }
  return run(
      fmt::format("{} fingers, {}", pinch.fingers, holds ? "held" : "slips"),
      [=] {
        return grip(pinch.fingers, pinch.mass, pinch.friction, constant(pinch.normal_force),
                    accelerating(pinch.acceleration * z_axis), end);
      },
      "L1: holds iff n mu_s N >= m (g + a), shared evenly; else slips by (g + a - n mu_d N / m) t^2 / 2",
      polynomial(end), claims);
}

Run at_threshold(double share) {
  exact::Pinch pinch{};
  pinch.normal_force = share * exact::critical_normal_force(pinch);
  return near_threshold(
      share,
      [=] {
        return Problem(grip(2, pinch.mass, pinch.friction, constant(pinch.normal_force),
                            accelerating(pinch.acceleration * z_axis), 0.02));
      },
      yes_or_no("holds", share > 1, "L1: n mu_s N >= m (g + a)", none_of(EventKind::breakaway)));
}

Case pinch() {
  return {.id = "L1-D01",
          .title = "Pinch under acceleration: threshold",
          .statement = "Two, three or five fingers lift a body with 1 m/s2.",
          .formula = "holds iff n mu_s N >= m (g + a)",
          .runs = {lifted({2, 2.5, 0.2, 1, g, {0.5, 0.4}}), lifted({2, 2.0, 0.2, 1, g, {0.5, 0.4}}),
                   lifted({3, 1.4, 0.2, 1, g, {0.5, 0.5}}), lifted({5, 0.8, 0.2, 1, g, {0.5, 0.4}}), at_threshold(0.98),
                   at_threshold(1.02), at_threshold(1 - 1e-9), at_threshold(1 + 1e-9)}};
}

Run opens(const std::string& name, const exact::PinchOpening& o) {
  const double onset = exact::slip_onset(o), open = exact::open_time(o), end = open + 0.1;
  const double onset_rate = 2 * o.friction.mu_static * o.rate / o.mass;
  std::vector<RigidClaim> claims;
  for (const int n : {1, 2}) {
    claims.push_back(event_time(fmt::format("slip onset of finger {}", n), EventKind::breakaway, n, onset, onset_rate));
    claims.push_back(event_time(fmt::format("release of finger {}", n), EventKind::release, n, open, o.rate / o.mass));
  }
  claims.push_back(way_at("fall at the release", z_axis, EventKind::release, 1, -exact::fall(o, open), o.rate / o.mass,
                          exact::fall_speed(o, open)));
  claims.push_back(way("fall at the end", z_axis, end, -exact::fall(o, end)));
  claims.push_back(speed("speed at the end", z_axis, end, -exact::fall_speed(o, end)));
  claims.push_back(event_count(EventKind::breakaway, 2));
  claims.push_back(event_count(EventKind::release, 2));
  claims.push_back(event_count(EventKind::restick, 0));
  claims.push_back(energy_balance(0.1));
  return run(
      name,
      [=] {
        return grip(
            2, o.mass, o.friction, [=](double t) { return o.normal_force - o.rate * t; }, {}, end);
      },
      "L1: t_s = (N0 - m g / (2 mu_s)) / r; g (1 - mu_d/mu_s) tau^2/2 + mu_d r tau^3 / (3 m), then free fall",
      controlled(), claims);
}

Case opening() {
  return {.id = "L1-D02",
          .title = "Pinch that opens",
          .statement = "Two fingers press less and less, N0 - r t; the body slips, then falls.",
          .formula = "t_s = (N0 - m g / (2 mu_s)) / r, t_open = N0 / r",
          .runs = {opens("2 N/s", {0.2, 4, 2, g, {0.5, 0.4}}),
                   opens("0.5 N/s, one coefficient", {0.2, 4, 0.5, g, {0.5, 0.5}}),
                   opens("10 N/s", {0.05, 1.5, 10, g, {0.8, 0.4}})}};
}

Case pinch_catch() {
  const exact::PinchCatch c{};
  const double stop = exact::stop_time(c), end = 0.6;
  const double rate = 2 * c.friction.mu_dynamic * (c.normal_force + c.rate * stop) / c.mass - g;
  std::vector<RigidClaim> claims{from_the_start("slides", EventKind::breakaway)};
  for (const int n : {1, 2})
    claims.push_back(event_time(fmt::format("stop at finger {}", n), EventKind::restick, n, stop, rate));
  claims.push_back(way_at("slip at the stop", z_axis, EventKind::restick, 1, -exact::slip(c)));
  claims.push_back(way("slip at the end", z_axis, end, -exact::slip(c)));
  claims.push_back(event_count(EventKind::restick, 2));
  claims.push_back(mode(0, end, Mode::stick));
  claims.push_back(force("friction of a finger, held", 1, z_axis, end, c.mass * g / 2, Through::sliding_speed, c.mass));
  claims.push_back(energy_balance(0.1));
  const Run caught = run(
      "catches and holds",
      [=] {
        RigidProblem p = grip(
            2, c.mass, c.friction, [=](double t) { return c.normal_force + c.rate * t; }, {}, end);
        p.V_WB.v = -c.speed * z_axis;
        return p;
      },
      "L1: t = (b + sqrt(b^2 + 2 c v0)) / c, b = g - 2 mu_d N0/m, c = 2 mu_d r/m", polynomial(end), claims);
  return {.id = "L1-D03",
          .title = "Catch by closing fingers",
          .statement = "A body slips down at 0.3 m/s between fingers that press with N0 + r t.",
          .formula = "t = (b + sqrt(b^2 + 2 c v0)) / c",
          .runs = {caught}};
}

Run shaken(const std::string& name, const exact::VerticalShake& s) {
  const double period = 2 * pi / s.frequency, w = s.frequency, Aww = s.amplitude * w * w;
  const bool slips = exact::slips(s);
  const double end = slips ? exact::stop_time(s) + 1.02 * period : 2 * period;
  std::vector<RigidClaim> claims{event_count(EventKind::breakaway, slips ? 4 : 0),
                                 event_count(EventKind::restick, slips ? 4 : 0), energy_balance(0.1)};
  if (!slips) claims.push_back(way("slip in the hand", z_axis, end, 0, s.amplitude));
  for (const int cycle : {0, 1}) {
    if (!slips) break;
    const double onset = exact::slip_onset(s), stop = exact::stop_time(s);
    const double decelerates = 2 * s.friction.mu_dynamic * s.normal_force / s.mass - g + Aww * std::sin(w * stop);
    const std::string of = fmt::format(" of cycle {}", cycle + 1);
    for (const int finger : {1, 2}) {
      const int n = 2 * cycle + finger;
      claims.push_back(event_time(fmt::format("slip onset{}, finger {}", of, finger), EventKind::breakaway, n,
                                  onset + cycle * period, std::abs(Aww * w * std::cos(w * onset))));
      claims.push_back(event_time(fmt::format("stop{}, finger {}", of, finger), EventKind::restick, n,
                                  stop + cycle * period, std::abs(decelerates)));
    }
    claims.push_back(
        way_at("slip by the end" + of, z_axis, EventKind::restick, 2 * cycle + 2, (cycle + 1) * exact::slip(s)));
  }
  return run(
      name,
      [=] {
        RigidProblem p = grip(2, s.mass, s.friction, constant(s.normal_force), sine(z_axis, s.amplitude, w), end);
        p.V_WB.v = s.amplitude * w * z_axis;
        return p;
      },
      "L1: t1 = (pi + asin((c_s - g) / (A w^2))) / w; stops where (c_d - g)(t - t1) = A w (cos wt - cos wt1)",
      controlled(), claims);
}

Run shaken_near(double share) {
  exact::VerticalShake s{};
  s.amplitude = share * exact::greatest_acceleration(s) / (s.frequency * s.frequency);
  return near_threshold(
      share,
      [=] {
        RigidProblem p = grip(2, s.mass, s.friction, constant(s.normal_force), sine(z_axis, s.amplitude, s.frequency),
                              2 * pi / s.frequency);
        p.V_WB.v = s.amplitude * s.frequency * z_axis;
        return Problem(p);
      },
      yes_or_no("holds", share < 1, "L1: A w^2 <= 2 mu_s N / m - g", none_of(EventKind::breakaway)));
}

Case vertical_shake() {
  return {.id = "L1-D04",
          .title = "Pinch shaken vertically",
          .statement = "Two fingers with 2.6 N each shake up and down: the body slips down once a cycle, or holds.",
          .formula = "slips iff A w^2 > 2 mu_s N / m - g",
          .runs = {shaken("20 rad/s", {0.2, 2.6, 0.02, 20, g, {0.5, 0.4}}),
                   shaken("25 rad/s, one coefficient", {0.2, 2.6, 0.01, 25, g, {0.5, 0.5}}),
                   shaken("holds", {0.2, 4, 0.005, 30, g, {0.5, 0.4}}), shaken_near(0.98), shaken_near(1.02)}};
}

/// The cone is round: onset and direction of a slip under gravity and a sideways shake, and how the slip turns after.
Case side_shake() {
  const exact::SideShake s{};
  const double mu_dynamic = 0.4, w = s.frequency, onset = exact::slip_onset(s), end = onset + 0.03;
  const exact::PlaneSlide slid = exact::slide(s, mu_dynamic, end);
  const double a = exact::acceleration_at_onset(s), limit = 2 * s.mu_static * s.normal_force / s.mass;
  const double rate = std::abs(a) * s.amplitude * w * w * w * std::cos(w * onset) / limit;
  std::vector<RigidClaim> claims{event_time("slip onset, finger 1", EventKind::breakaway, 1, onset, rate),
                                 event_time("slip onset, finger 2", EventKind::breakaway, 2, onset, rate),
                                 event_count(EventKind::breakaway, 2)};
  const std::vector<RigidClaim> after{way("slip sideways", x_axis, end, slid.x[0], slid.x.norm()),
                                      way("slip down", z_axis, end, slid.x[1], slid.x.norm()),
                                      speed("speed sideways", x_axis, end, slid.u[0], slid.u.norm()),
                                      speed("speed down", z_axis, end, slid.u[1], slid.u.norm())};
  for (RigidClaim c : after) {
    c.claim.pedigree = Pedigree::converged;
    claims.push_back(c);
  }
  const Run slips = run(
      "slips",
      [=] {
        RigidProblem p =
            grip(2, s.mass, {s.mu_static, mu_dynamic}, constant(s.normal_force), sine(x_axis, s.amplitude, w), end);
        p.V_WB.v = s.amplitude * w * x_axis;
        return p;
      },
      "L1: sin(w t) = sqrt(c^2 - g^2) / (A w^2); the slide by Runge and Kutta's steps of 1 us", controlled(), claims);
  const auto near = [=](double share) {
    exact::SideShake at = s;
    at.amplitude = share * std::sqrt(limit * limit - g * g) / (w * w);
    return near_threshold(
        share,
        [=] {
          RigidProblem p = grip(2, s.mass, {s.mu_static, mu_dynamic}, constant(s.normal_force),
                                sine(x_axis, at.amplitude, w), pi / w);
          p.V_WB.v = at.amplitude * w * x_axis;
          return Problem(p);
        },
        yes_or_no("holds", exact::holds(at), "L1: g^2 + (A w^2)^2 <= (2 mu_s N / m)^2", none_of(EventKind::breakaway)));
  };
  return {.id = "L1-D06",
          .title = "Pinch shaken sideways: the round cone",
          .statement = "Two fingers that hold a weight shake sideways; the cone limits the sum of both loads.",
          .formula = "holds iff g^2 + (A w^2)^2 <= (2 mu_s N / m)^2",
          .runs = {slips, near(0.98), near(1.02)}};
}

}  // namespace

std::vector<Case> rigid_pinches() { return {pinch(), opening(), pinch_catch(), vertical_shake(), side_shake()}; }

}  // namespace handhold::catalogue
