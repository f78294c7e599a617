// SPDX-License-Identifier: GPL-3.0-or-later
// A small object slides on curved faces: L1-C14 to C16.

#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/rigid.hpp"
#include "cases/catalogue/builders/rigid_claims.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/curved_slide.hpp"

namespace handhold::catalogue {
namespace {

namespace exact = closed_form;
using namespace rigid;

constexpr double mass = 0.2;

Run off_dome(const std::string& name, const RigidSurface& surface, const exact::Dome& d) {
  const double t = exact::lift_off_time(d), a = exact::lift_off_angle(d), v = exact::lift_off_speed(d);
  const double R = d.radius, a0 = d.start_angle, rate = 3 * g * std::sin(a) * v / R;
  const double grown = std::exp(std::sqrt(g / R) * t);
  std::vector<RigidClaim> claims{
      from_the_start("slides", EventKind::breakaway),
      event_time("lift-off", EventKind::release, 1, t, rate),
      way_at("way along x at lift-off", x_axis, EventKind::release, 1, R * (std::sin(a) - std::sin(a0)), rate, v),
      way_at("way along z at lift-off", z_axis, EventKind::release, 1, R * (std::cos(a) - std::cos(a0)), rate, v),
      speed_at("speed along x at lift-off", x_axis, EventKind::release, 1, v * std::cos(a)),
      speed_at("speed along z at lift-off", z_axis, EventKind::release, 1, -v * std::sin(a)),
      event_count(EventKind::release, 1),
      energy_balance(0.1)};
  return run(
      name,
      [=] {
        RigidProblem p = block(mass, {d.mu, d.mu}, t + 0.05);
        p.supports[0].surface = surface;
        p.X_WB.p = R * Eigen::Vector3d(std::sin(a0), 0, std::cos(a0));
        p.V_WB.v = d.start_speed * Eigen::Vector3d(std::cos(a0), 0, -std::sin(a0));
        return p;
      },
      "L1: w = v^2 obeys dw/da = 2 g R sin - 2 mu (g R cos - w); lift-off at w = g R cos (Mungan 2003)",
      controlled(grown, fmt::format("off a dome errors grow as exp(t sqrt(g/R)), here {:.0f}-fold", grown)), claims);
}

Case dome() {
  const exact::Dome rest{0.1, 0.3, 0.35, 0, g}, pushed{0.1, 0.5, 0.1, 0.7, g};
  const RigidSurface ball = make_sphere({0, 0, 0}, 0.1), log = make_cylinder({0, 0, 0}, y_axis, 0.1);
  return {.id = "L1-C14",
          .title = "Sliding off a dome",
          .statement = "A small object slides off a sphere or a lying cylinder, from rest or pushed.",
          .formula = "lift-off where v^2 = g R cos(a)",
          .runs = {off_dome("sphere, from rest", ball, rest), off_dome("sphere, pushed", ball, pushed),
                   off_dome("cylinder, from rest", log, rest), off_dome("cylinder, pushed", log, pushed)}};
}

Run in_bowl(const std::string& name, const RigidSurface& surface, const exact::Bowl& b) {
  const std::vector<double> angles = exact::turning_angles(b), times = exact::turning_times(b);
  const double R = b.radius, end = times.back() + 0.1;
  std::vector<RigidClaim> claims{from_the_start("slides", EventKind::breakaway)};
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const double a = std::abs(angles[i]);
    const double rate = g * (std::sin(a) + b.friction.mu_dynamic * std::cos(a));
    const int n = int(i);
    claims.push_back(event_time(fmt::format("stop {}", n), EventKind::restick, n, times[i], rate));
    RigidClaim x = way_at(fmt::format("way along x to stop {}", n), x_axis, EventKind::restick, n,
                          R * (std::sin(angles[i]) - std::sin(b.start_angle)));
    x.claim.scale = R;
    claims.push_back(x);
  }
  claims.push_back(event_count(EventKind::restick, int(angles.size()) - 1));
  claims.push_back(mode(0, end, Mode::stick));
  claims.push_back(energy_balance(0.1));
  return run(
      name,
      [=] {
        RigidProblem p = block(mass, b.friction, end);
        p.supports[0].surface = surface;
        p.X_WB.p = R * Eigen::Vector3d(std::sin(b.start_angle), 0, -std::cos(b.start_angle));
        return p;
      },
      "L1: v^2 = C e^(-2 mu a) + A cos(a) + B sin(a) of every swing; times by quadrature", controlled(), claims);
}

Case bowl() {
  const RigidSurface gutter = make_cylinder({0, 0, 0}, y_axis, 0.08, true);
  const exact::Bowl rough{0.08, 1.2, g, {0.25, 0.2}}, smooth{0.08, 1.4, g, {0.1, 0.1}};
  return {.id = "L1-C15",
          .title = "Sliding in a bowl or gutter",
          .statement = "A small object is let go in a gutter or bowl and swings to and fro until it stays.",
          .formula = "v^2 = C e^(-2 mu a) + A cos(a) + B sin(a)",
          .runs = {in_bowl("gutter", gutter, rough), in_bowl("smooth gutter", gutter, smooth),
                   in_bowl("bowl", make_sphere({0, 0, 0}, 0.08, true), rough)}};
}

Case wall() {
  const exact::WallSlide w{};
  const double stop = exact::stop_time(w), end = stop + 0.1, swept = exact::swept_angle(w), R = w.radius;
  std::vector<RigidClaim> claims{from_the_start("slides", EventKind::breakaway)};
  for (const int k : {15, 40}) {
    const double t = k / 90., a = exact::angle_at(w, t);
    if (t > stop) continue;
    claims.push_back(way(fmt::format("way along x on frame {}", k), x_axis, t, R * (std::cos(a) - 1), R));
    claims.push_back(way(fmt::format("way along y on frame {}", k), y_axis, t, R * std::sin(a), R));
    claims.push_back(speed(fmt::format("speed on frame {}", k), Eigen::Vector3d(-std::sin(a), std::cos(a), 0), t,
                           exact::speed_at(w, t)));
  }
  // The wall, whose force goes to zero at the same moment, may leave a little before, by noise: the floor stops it.
  claims.push_back(event_time("stop on the floor", EventKind::restick, 1, stop, w.mu_floor * g, 0));
  claims.push_back(way("way along x at the end", x_axis, end, R * (std::cos(swept) - 1), R));
  claims.push_back(way("way along y at the end", y_axis, end, R * std::sin(swept), R));
  claims.push_back(mode(0, end, Mode::stick));
  claims.push_back(energy_balance(0.2));
  const Run along = run(
      "to the stop",
      [=] {
        RigidProblem p = block(mass, {w.mu_floor, w.mu_floor}, end);
        RigidSupport round;
        round.surface = make_cylinder({0, 0, 0}, z_axis, R, true);
        round.friction = {w.mu_wall, w.mu_wall};
        p.supports.push_back(round);
        p.X_WB.p = R * x_axis;
        p.V_WB.v = w.speed * y_axis;
        return p;
      },
      "L1: v' = -(mu_w / R) v^2 - mu_f g; stops at atan(v0 sqrt(b/a)) / sqrt(ab)", controlled(), claims);
  return {.id = "L1-C16",
          .title = "Puck along a circular wall",
          .statement = "A puck slides along the inside of a circular wall on a rough floor: two contacts rub.",
          .formula = "swept angle ln(1 + mu_w v0^2 / (mu_f g R)) / (2 mu_w)",
          .runs = {along}};
}

}  // namespace

std::vector<Case> rigid_curves() { return {dome(), bowl(), wall()}; }

}  // namespace handhold::catalogue
