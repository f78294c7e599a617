// SPDX-License-Identifier: GPL-3.0-or-later
// A block slides on a plane: L1-C01 to C04, C20.

#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/rigid.hpp"
#include "cases/catalogue/builders/rigid_claims.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/incline.hpp"
#include "cases/closed_form/pushed_block.hpp"
#include "cases/closed_form/stopping.hpp"

namespace handhold::catalogue {
namespace {

namespace exact = closed_form;
using namespace rigid;

constexpr double mass = 0.2;
constexpr Friction friction{0.5, 0.4};

/// Of a stepped method after a phase of constant acceleration (R03), and the events that end it.
RigidClaim stepped(RigidClaim claim, const Limit& limit) {
  claim.stepped = limit;
  return claim;
}

Limit speed_within_a_step(double acceleration) {
  return {.per_step = 1.01 * std::abs(acceleration),
          .reason = "a step's change of speed, where the slide begins or ends"};
}

RigidProblem on_slope(double slope, double duration) {
  RigidProblem p = block(mass, friction, duration);
  p.gravity = tilted_gravity(slope);
  return p;
}

Run slides_down(double slope) {
  const exact::Incline incline{slope, g, friction};
  const double way_down = 0.1, end = exact::time_at(incline, way_down), v = exact::speed_at(incline, way_down);
  const double rubs = friction.mu_dynamic * mass * g * std::cos(slope);
  return run(fmt::format("slope {} rad", slope), [=] { return on_slope(slope, end); },
             "L1: D = a t^2 / 2, v = sqrt(2 a D), a = g (sin - mu_d cos)", polynomial(end, v),
             {from_the_start("slip onset", EventKind::breakaway),
              stepped(way("slip", x_axis, end, way_down), euler_bias_limit(v)),
              stepped(speed("speed", x_axis, end, v), speed_within_a_step(v / end)),
              stepped(dissipated(end, rubs * way_down), {.per_step = rubs * 0.51 * v,
                                                         .reason = "friction times the "
                                                                   "bias of the way (R03)"}),
              energy_balance(0.1)});
}

/// On a plane that is tilted itself, in an odd direction: nothing is aligned with the axes.
Run slides_down_askew() {
  const exact::Incline incline{0.6, g, friction};
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, z_axis) * Eigen::AngleAxisd(0.6, y_axis));
  const double end = exact::time_at(incline, 0.1), v = exact::speed_at(incline, 0.1);
  const Eigen::Vector3d down = turn * x_axis, across = turn * y_axis;
  return run("on a plane in an odd direction",
             [=] {
               RigidProblem p = block(mass, friction, end);
               p.supports[0].surface = make_plane({0, 0, 0}, turn * z_axis);
               return p;
             },
             "L1: straight down the plane, D = a t^2 / 2", polynomial(end, v),
             {way("slip along x", x_axis, end, 0.1 * down.x()), way("slip along y", y_axis, end, 0.1 * down.y()),
              way("slip along z", z_axis, end, 0.1 * down.z()), way("slip across", across, end, 0, 0.1),
              speed("speed down the plane", down, end, v), energy_balance(0.1)});
}

Case incline() {
  const auto near = [=](double share) {
    return near_threshold(
        share, [=] { return Problem(on_slope(std::atan(share * friction.mu_static), 0.3)); },
        yes_or_no("stays", share < 1, "L1: tan(slope) <= mu_s", none_of(EventKind::breakaway)));
  };
  return {.id = "L1-C01",
          .title = "Incline: threshold and slide",
          .statement = "A 0.2 kg block is let go at rest on a slope; mu_s = 0.5, mu_d = 0.4.",
          .formula = "slips iff tan(slope) > mu_s; then a = g (sin - mu_d cos)",
          .runs = {slides_down(0.5), slides_down(0.7), slides_down(1.2), slides_down_askew(), near(0.98), near(1.02),
                   near(1 - 1e-9), near(1 + 1e-9)}};
}

Run flicked(double slope) {
  const exact::Flick flick{slope, 1, g, friction};
  const bool returns = exact::returns(flick);
  const double stop = exact::stop_time(flick), end = stop + (returns ? exact::return_time(flick) : 0.1);
  std::vector<RigidClaim> claims{
      from_the_start("slides", EventKind::breakaway),
      stepped(event_time("stop", EventKind::restick, 1, stop, flick.speed / stop), event_limit()),
      stepped(way_at("slip at the stop", x_axis, EventKind::restick, 1, -exact::stop_distance(flick)),
              euler_bias_limit(flick.speed)),
      event_count(EventKind::breakaway, returns ? 2 : 1),
      event_count(EventKind::restick, 1),
      energy_balance(0.1)};
  if (returns) {
    claims.push_back(event_time("turn", EventKind::breakaway, 2, stop, flick.speed / stop));
    claims.push_back(way("place on return", x_axis, end, 0, exact::stop_distance(flick)));
    claims.push_back(speed("speed on return", x_axis, end, exact::return_speed(flick)));
  } else {
    claims.push_back(way("place at the end", x_axis, end, -exact::stop_distance(flick)));
    claims.push_back(mode(0, end, Mode::stick));
  }
  return run(
      returns ? "comes back" : "stays up",
      [=] {
        RigidProblem p = on_slope(slope, end);
        p.V_WB.v = -flick.speed * x_axis;
        return p;
      },
      "L1: t = v0 / (g (sin + mu_d cos)), back at v0 sqrt((sin - mu_d cos) / (sin + mu_d cos))", polynomial(end),
      claims);
}

Case flick() {
  return {.id = "L1-C02",
          .title = "Incline: up, and back or not",
          .statement = "The block is flicked up a slope of 0.6 or 0.4 rad at 1 m/s.",
          .formula = "stops at v0 / (g (sin + mu_d cos)); returns iff tan(slope) > mu_s",
          .runs = {flicked(0.6), flicked(0.4)}};
}

Run stops(double palm) {
  const exact::Stopping s{};
  const double end = 0.3, stop = exact::stop_time(s), rubs = s.mu_dynamic * s.mass * s.gravity;
  return run(
      palm == 0 ? "palm at rest" : "palm moves along",
      [=] {
        RigidProblem p = block(s.mass, {0.5, s.mu_dynamic}, end);
        p.V_WB.v = (palm + s.speed) * x_axis;
        p.supports[0].motion = steady(palm * x_axis);
        return p;
      },
      "L1: t = v0 / (mu_d g), D = v0^2 / (2 mu_d g), heat m v0^2 / 2; the same on a palm that moves (Galilei)",
      polynomial(end, palm + s.speed),
      {stepped(event_time("stop", EventKind::restick, 1, stop, s.mu_dynamic * g), event_limit()),
       stepped(way_at("slip at the stop", x_axis, EventKind::restick, 1, exact::stop_distance(s)),
               euler_bias_limit(s.speed)),
       stepped(way("slip on the way", x_axis, 9 / 90., exact::distance(s, 9 / 90.)),
               euler_bias_limit(s.mu_dynamic * g * 9 / 90.)),
       stepped(way("slip at the end", x_axis, end, exact::stop_distance(s)), euler_bias_limit(s.speed)),
       event_count(EventKind::restick, 1), dissipated(end, exact::heat(s), rubs), energy_balance(exact::heat(s))});
}

Case stopping() {
  return {.id = "L1-C03",
          .title = "Sliding stop on a level palm",
          .statement = "A block slides at 0.8 m/s on a palm that rests or moves along at 0.35 m/s; mu_d = 0.4.",
          .formula = "t = v0 / (mu_d g), D = v0^2 / (2 mu_d g)",
          .runs = {stops(0), stops(0.35)}};
}

Case load_ramp() {
  const exact::LoadRamp ramp{};
  const double end = 1.2, onset = exact::slip_onset(ramp);
  const Run pulled =
      run("pulled",
          [=] {
            RigidProblem p = block(ramp.mass, ramp.friction, end);
            p.load = [=](double t, const BodyState&) { return Load{ramp.rate * t * x_axis, {0, 0, 0}}; };
            return p;
          },
          "L1: t_s = mu_s m g / r, x = (mu_s - mu_d) g tau^2 / 2 + r tau^3 / (6 m)", polynomial(end, 2),
          {event_time("slip onset", EventKind::breakaway, 1, onset, ramp.rate / ramp.mass),
           way("place at the end", x_axis, end, exact::distance(ramp, end)),
           speed("speed at the end", x_axis, end, exact::speed(ramp, end)),
           way("place before", x_axis, 45 / 90., 0, exact::distance(ramp, end)),
           force("friction that holds", 0, x_axis, 45 / 90., -ramp.rate * 45 / 90, Through::sliding_speed, ramp.mass),
           event_count(EventKind::breakaway, 1),
           dissipated(end, ramp.friction.mu_dynamic * ramp.mass * g * exact::distance(ramp, end)), energy_balance(1)});
  return {.id = "L1-C04",
          .title = "Load ramp: breakaway and slide",
          .statement = "A block at rest is pulled with F = 2 N/s t; mu_s = 0.6, mu_d = 0.4.",
          .formula = "t_s = mu_s m g / r",
          .runs = {pulled}};
}

/// Friction turns by 2.1 rad: the direction of sliding is the velocity's in two dimensions, down to the stop.
Run slides_across(double slope) {
  const exact::ObliqueSlide s{slope, 0.45, 1.2, 2.1, g};
  const bool stops = s.mu > std::tan(slope);
  const exact::ObliquePoint end = exact::at_angle(s, stops ? 0 : 0.2);
  const double duration = stops ? end.t + 0.1 : end.t;
  std::vector<RigidClaim> claims{way("way down", x_axis, duration, end.downhill, 0.1),
                                 way("way across", y_axis, duration, end.across, 0.1), energy_balance(0.1)};
  if (stops) {
    claims.push_back(event_time("stop", EventKind::restick, 1, end.t, g * (s.mu * std::cos(slope) - std::sin(slope))));
    claims.push_back(mode(0, duration, Mode::stick));
  } else {
    claims.push_back(speed("speed down", x_axis, duration, end.speed * std::cos(0.2)));
    claims.push_back(speed("speed across", y_axis, duration, end.speed * std::sin(0.2)));
  }
  claims.push_back(event_count(EventKind::restick, stops ? 1 : 0));
  return run(
      stops ? "to the stop" : "down the slope",
      [=] {
        RigidProblem p = block(mass, {s.mu, s.mu}, duration);
        p.gravity = tilted_gravity(slope);
        p.V_WB.v = s.speed * Eigen::Vector3d(std::cos(s.angle), std::sin(s.angle), 0);
        return p;
      },
      "L1: v = c tau^(k-1) (1 + tau^2), tau = tan(phi / 2), k = mu / tan(slope)", controlled(), claims);
}

Case oblique_slide() {
  return {.id = "L1-C20",
          .title = "Slide across a slope",
          .statement = "A block starts at 1.2 m/s at 2.1 rad to the fall line; its friction turns with its way.",
          .formula = "v = c tau^(k-1) (1 + tau^2), tau = tan(phi / 2)",
          .runs = {slides_across(0.3), slides_across(0.7)}};
}

}  // namespace

std::vector<Case> rigid_slides() { return {incline(), flick(), stopping(), load_ramp(), oblique_slide()}; }

}  // namespace handhold::catalogue
