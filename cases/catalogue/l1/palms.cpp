// SPDX-License-Identifier: GPL-3.0-or-later
// A body lies on a palm that lifts, tilts or turns: L1-C11, C12, D13.

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/builders/rigid.hpp"
#include "cases/catalogue/builders/rigid_claims.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/palm_lift.hpp"
#include "cases/closed_form/turning_palm.hpp"

namespace handhold::catalogue {
namespace {

namespace exact = closed_form;
using namespace rigid;

constexpr double mass = 0.2;

Run leaves_and_lands(const std::string& name, const exact::PalmLift& l) {
  const double w = l.frequency, off = exact::lift_off(l), on = exact::landing(l), end = on + 0.01;
  const double v = exact::landing_speed(l);
  std::vector<RigidClaim> claims{
      event_time("lift-off", EventKind::release, 1, off, l.amplitude * w * w * w * std::cos(w * off)),
      event_time("landing", EventKind::touch, 1, on, std::abs(v)),
      way_at("way over the hand at landing", z_axis, EventKind::touch, 1, 0),
      speed_at("speed over the hand after landing", z_axis, EventKind::touch, 1, 0, std::abs(v)),
      event_count(EventKind::touch, 1),
      dissipated(end, mass * v * v / 2),
      energy_balance(0.2)};
  const bool stays = l.amplitude * w * w * std::sin(w * end) < g;  // else the palm drops away from it again
  claims.push_back(event_count(EventKind::release, stays ? 1 : 2));
  claims.push_back(mode(0, end, stays ? Mode::stick : Mode::apart));
  claims[2].claim.scale = l.amplitude;
  for (const double frame : std::set<double>{std::floor(90 * 0.4 * off), std::floor(90 * 0.9 * off)}) {
    const double t = frame / 90;
    claims.push_back(force(fmt::format("normal force on frame {:.0f}", frame), 0, z_axis, t,
                           mass * (g - l.amplitude * w * w * std::sin(w * t)), Through::gap, mass, mass * g));
  }
  return run(
      name,
      [=] {
        RigidProblem p = block(mass, {0.5, 0.4}, end);
        p.supports[0].motion = sine(z_axis, l.amplitude, w);
        p.V_WB.v = l.amplitude * w * z_axis;
        return p;
      },
      "L1: sin(w t1) = g / (A w^2), then free flight; a plastic landing takes m v^2 / 2", controlled(), claims);
}

Case palm_lift() {
  const auto near = [](double share) {
    const exact::PalmLift l{share * g / (18 * 18), 18, g, mass, 0};
    return near_threshold(
        share,
        [=] {
          RigidProblem p = block(mass, {0.5, 0.4}, 0.3);
          p.supports[0].motion = sine(z_axis, l.amplitude, l.frequency);
          p.V_WB.v = l.amplitude * l.frequency * z_axis;
          return Problem(p);
        },
        yes_or_no("stays on the palm", !exact::leaves(l), "L1: leaves iff A w^2 > g", none_of(EventKind::release)));
  };
  return {.id = "L1-D13",
          .title = "Palm lift: leaving and landing",
          .statement = "A block rests on a palm that moves up and down as A sin(w t).",
          .formula = "leaves at sin(w t1) = g / (A w^2)",
          .runs = {leaves_and_lands("18 rad/s", {0.05, 18, g, mass, 0}),
                   leaves_and_lands("40 rad/s", {0.02, 40, g, mass, 0}), near(0.98), near(1.02)}};
}

Run tilts(const std::string& name, const exact::TiltingPalm& p, double slide_time) {
  const double W = p.rate, onset = exact::slip_onset(p), end = onset + slide_time, angle = W * end;
  const double x = exact::place(p, end), v = exact::speed(p, end), x0 = p.distance;
  const Eigen::Vector3d along(std::cos(angle), 0, std::sin(angle)), normal(-std::sin(angle), 0, std::cos(angle));
  const double rate = g * W * (std::cos(W * onset) + p.friction.mu_static * std::sin(W * onset));
  std::vector<RigidClaim> claims{
      event_time("slip onset", EventKind::breakaway, 1, onset, rate),
      way_at("way along x at the onset", x_axis, EventKind::breakaway, 1, x0 * (std::cos(W * onset) - 1), rate, W * x0),
      way_at("way along z at the onset", z_axis, EventKind::breakaway, 1, x0 * std::sin(W * onset), rate, W * x0),
      way("way along x at the end", x_axis, end, x * along.x() - x0),
      way("way along z at the end", z_axis, end, x * along.z()),
      speed("speed along the palm", along, end, v),
      speed("speed with the palm", normal, end, W * x),
      force("normal force", 0, normal, end, mass * exact::normal_acceleration(p, end), Through::gap, mass),
      force("friction", 0, along, end, p.friction.mu_dynamic * mass * exact::normal_acceleration(p, end), Through::gap,
            mass),
      event_count(EventKind::breakaway, 1),
      energy_balance(0.1)};
  return run(
      name,
      [=] {
        RigidProblem problem = block(mass, p.friction, end);
        problem.supports[0].turn = turning(-y_axis, W);
        problem.X_WB.p = x0 * x_axis;
        problem.V_WB.v = W * x0 * z_axis;
        return problem;
      },
      "L1: g sin = mu_s g cos + x0 W^2; x'' - W^2 x = -g sin(Wt) + mu_d (g cos(Wt) + 2 W x')", controlled(), claims);
}

Case tilting_palm() {
  return {.id = "L1-C11",
          .title = "Palm that tilts at a constant rate",
          .statement = "A block lies on a palm that is raised about a hinge; it slides down to the hinge.",
          .formula = "slips at phi + asin(x0 W^2 cos(phi) / g), phi = atan(mu_s); N = m (g cos + 2 W x')",
          .runs = {tilts("1.5 rad/s", {0.08, 1.5, g, {0.4, 0.4}}, 0.15),
                   tilts("0.2 rad/s", {0.05, 0.2, g, {0.6, 0.6}}, 0.2),
                   tilts("1 rad/s, two coefficients", {0.1, 1, g, {0.5, 0.3}}, 0.15)}};
}

Run spins_up(const std::string& name, const exact::SpunPalm& s, double mu_dynamic) {
  const double w = s.acceleration * exact::slip_onset(s), onset = exact::slip_onset(s), end = onset + 0.03;
  const double R = s.radius, angle = s.acceleration * onset * onset / 2;
  const double rate = 2 * w * w * w * s.acceleration * R * R / (s.mu_static * g);
  const exact::SpunPlace slid = exact::slide(s, mu_dynamic, end);
  std::vector<RigidClaim> claims{
      event_time("slip onset", EventKind::breakaway, 1, onset, rate),
      way_at("way along x at the onset", x_axis, EventKind::breakaway, 1, R * (std::cos(angle) - 1), rate, w * R),
      way_at("way along y at the onset", y_axis, EventKind::breakaway, 1, R * std::sin(angle), rate, w * R),
      event_count(EventKind::breakaway, 1),
      event_count(EventKind::restick, 0),
      mode(0, end, Mode::slip),
      energy_balance(0.1)};
  const std::vector<RigidClaim> after{way("way along x at the end", x_axis, end, slid.p.x() - R, R),
                                      way("way along y at the end", y_axis, end, slid.p.y(), R),
                                      speed("speed along x at the end", x_axis, end, slid.v.x(), w * R),
                                      speed("speed along y at the end", y_axis, end, slid.v.y(), w * R)};
  for (RigidClaim c : after) {
    c.claim.pedigree = Pedigree::converged;
    claims.push_back(c);
  }
  return run(
      name,
      [=] {
        RigidProblem p = block(mass, {s.mu_static, mu_dynamic}, end);
        p.supports[0].turn = turning(z_axis, 0, s.acceleration);
        p.X_WB.p = R * x_axis;
        return p;
      },
      "L1: (w^2 R)^2 + (alpha R)^2 = (mu_s g)^2; the slide by Runge and Kutta's steps of 1 us in the palm's frame",
      controlled(), claims);
}

Case spun_palm() {
  return {.id = "L1-C12",
          .title = "Palm that is spun up",
          .statement = "A block lies off the axis of a level palm that turns faster and faster.",
          .formula = "t_s = [((mu_s g / (R alpha))^2 - 1) / alpha^2]^(1/4)",
          .runs = {spins_up("8 rad/s2", {0.1, 8, g, 0.4}, 0.3), spins_up("20 rad/s2", {0.15, 20, g, 0.5}, 0.35)}};
}

}  // namespace

std::vector<Case> rigid_palms() { return {tilting_palm(), spun_palm(), palm_lift()}; }

}  // namespace handhold::catalogue
