// SPDX-License-Identifier: GPL-3.0-or-later
// A ball slides and rolls: L1-E01 to E07.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cases/catalogue/builders/rigid.hpp"
#include "cases/catalogue/builders/rigid_claims.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/pendulum.hpp"
#include "cases/closed_form/rolling.hpp"
#include "cases/closed_form/turning_palm.hpp"

namespace handhold::catalogue {
namespace {

namespace exact = closed_form;
using namespace rigid;

/// Slides, then rolls.
Run to_rolling(const std::string& name, const exact::SlidingBall& b, double mass) {
  const double roll = exact::roll_time(b), end = roll + 0.1, r = b.radius;
  const Eigen::Vector2d v = exact::roll_velocity(b), p = exact::position(b, end), mid = exact::position(b, roll);
  const double scale = mid.norm();
  RigidClaim x = way_at("way along x at rolling", x_axis, EventKind::restick, 1, mid.x(), b.mu * g, v.norm());
  RigidClaim y = way_at("way along y at rolling", y_axis, EventKind::restick, 1, mid.y(), b.mu * g, v.norm());
  x.claim.scale = y.claim.scale = scale;
  const std::vector<RigidClaim> claims{from_the_start("slides", EventKind::breakaway),
                                       event_time("rolls", EventKind::restick, 1, roll, b.mu * g * (1 + 1 / b.beta)),
                                       x,
                                       y,
                                       way("way along x at the end", x_axis, end, p.x(), scale),
                                       way("way along y at the end", y_axis, end, p.y(), scale),
                                       speed("speed along x", x_axis, end, v.x(), 1),
                                       speed("speed along y", y_axis, end, v.y(), 1),
                                       spin("spin about x", x_axis, end, -v.y() / r, 1 / r, 1 / r),
                                       spin("spin about y", y_axis, end, v.x() / r, 1 / r, 1 / r),
                                       spin("spin about the vertical", z_axis, end, b.spin.z(), 1, 1 / r),
                                       event_count(EventKind::restick, 1),
                                       dissipated(end, mass * exact::heat_per_mass(b), b.mu * mass * g),
                                       energy_balance(0.1)};
  const double size = std::max({1.0, exact::sliding_velocity(b).norm(), b.spin.norm() / 10});
  return run(
      name,
      [=] {
        RigidProblem problem = ball(mass, r, b.beta, b.mu, end);
        problem.V_WB.v.head<2>() = b.velocity;
        problem.V_WB.w = b.spin;
        return problem;
      },
      "L1: slides for |u0| / (mu g (1 + 1/beta)) in one direction (Coriolis 1835), then v = (v0 + beta r w0 x z) / (1 "
      "+ "
      "beta)",
      polynomial(end, size), claims);
}

Case bowling_ball() {
  return {.id = "L1-E01",
          .title = "Bowling ball: slide to roll",
          .statement = "A ball starts on a floor along a line: without spin, with back spin, with top spin.",
          .formula = "rolls after |u0| / (mu g (1 + 1/beta))",
          .runs = {to_rolling("without spin", {0.04, 0.4, 0.3, {1.5, 0}, {0, 0, 0}, g}, 0.3),
                   to_rolling("hollow, back spin", {0.04, 0.5, 0.3, {1.5, 0}, {0, -60, 0}, g}, 0.3),
                   to_rolling("hoop, top spin", {0.04, 1.0, 0.3, {0.2, 0}, {0, 30, 0}, g}, 0.3)}};
}

Case masse() {
  return {.id = "L1-E02",
          .title = "Masse shot",
          .statement = "A ball starts with any velocity and spin: its way is a parabola until it rolls.",
          .formula = "x = v0 t - mu g u0/|u0| t^2 / 2",
          .runs = {to_rolling("billiards", {0.03, 0.4, 0.25, {1, 0.2}, {40, 10, 5}, g}, 0.17),
                   to_rolling("hollow", {0.05, 0.6, 0.2, {0.4, -0.9}, {12, -25, 3}, g}, 0.3)}};
}

Case rolled_ball() {
  const exact::RolledBall b{};
  const double onset = exact::slip_onset(b), end = onset + 0.2, t = 10 / 90.;
  const double pull = 2 * b.mu * b.normal_force / (b.mass * (1 + b.beta));
  const double v = b.jerk * onset * onset / 4 + pull * (end - onset), last = exact::position(b, end);
  const double way_of_plate = b.jerk * end * end * end / 6;
  const std::vector<RigidClaim> claims{
      event_time("slip onset", EventKind::breakaway, 1, onset, b.jerk * (1 + b.beta) / 4, 1),
      way("way on frame 10", x_axis, t, exact::position(b, t), last),
      way("way at the end", x_axis, end, last),
      way("half of what the plate has not slipped", x_axis, end, (way_of_plate - exact::slip(b, end)) / 2),
      speed("speed at the end", x_axis, end, v),
      spin("spin at the end", y_axis, end, v / b.radius, 1 / b.radius),
      force("friction of the plate above", 1, x_axis, t, b.mass * b.jerk * t * (1 + b.beta) / 4, Through::sliding_speed,
            b.mass),
      force("friction of the plate below", 0, x_axis, t, b.mass * b.jerk * t * (1 - b.beta) / 4, Through::sliding_speed,
            b.mass),
      force("friction of the plate above, slipping", 1, x_axis, end, b.mu * b.normal_force, Through::sliding_speed,
            b.mass),
      mode(0, end, Mode::stick),
      mode(1, end, Mode::slip),
      event_count(EventKind::breakaway, 1),
      energy_balance(0.1)};
  const Run rolled = run(
      "rolls, then slips above",
      [=] {
        return ball_between_plates(b.mass, b.radius, b.beta, b.normal_force, b.mu, jerking(b.jerk * x_axis), {}, end);
      },
      "L1: rolls at half the plate's way; slips from t_s = 4 mu N / (m j (1 + beta)) on, then a = 2 mu N / (m (1 + "
      "beta))",
      controlled(), claims);
  return {.id = "L1-E03",
          .title = "Ball rolled between two plates",
          .statement = "A ball lies on a plate and is rolled by one that presses from above and moves as j t^3 / 6.",
          .formula = "t_s = 4 mu N / (m j (1 + beta))",
          .runs = {rolled}};
}

Run carried(double lower) {
  exact::CarriedBall b{};
  b.lower = lower;
  const double roll = exact::roll_time(b), end = 0.04, v = exact::roll_speed(b);
  const int slipping = lower == 0 ? 1 : 2;
  std::vector<RigidClaim> claims{from_the_start("slides", EventKind::breakaway)};
  for (int n = 1; n <= slipping; ++n)
    claims.push_back(event_time(fmt::format("rolls on {}", n), EventKind::restick, n, roll, b.upper / roll));
  claims.push_back(event_count(EventKind::restick, slipping));
  claims.push_back(event_count(EventKind::breakaway, slipping));
  claims.push_back(speed("speed over the plate below", x_axis, end, v - lower, 0.2));
  claims.push_back(spin("spin", y_axis, end, exact::roll_spin(b), 1 / b.radius, 10));
  claims.push_back(dissipated(end, exact::heat(b), b.mu * b.normal_force));
  claims.push_back(energy_balance(0.01));
  return run(
      fmt::format("plate below at {} m/s", lower),
      [=] {
        return ball_between_plates(b.mass, b.radius, b.beta, b.normal_force, b.mu, steady(b.upper * x_axis),
                                   steady(lower * x_axis), end);
      },
      "L1: rolls after m (1 + beta) V / (4 mu N), beta m V / (2 mu N) or m V / (2 mu N), with (V1 + V2) / 2",
      polynomial(end, 10), claims);
}

Case carried_ball() {
  return {.id = "L1-E04",
          .title = "Ball carried between two plates",
          .statement = "A ball at rest is caught by plates at 0.2 m/s above and 0, -0.2 or 0.2 m/s below.",
          .formula = "v = (V1 + V2) / 2, w = (V1 - V2) / (2 r)",
          .runs = {carried(0), carried(-0.2), carried(0.2)}};
}

Run down(const exact::RollDown& b) {
  const double end = exact::time_at(b, 0.2), spun = exact::spin_at(b, 0.2), a = exact::acceleration(b);
  const bool rolls = exact::rolls(b);
  const std::vector<RigidClaim> claims{way("way", x_axis, end, 0.2),
                                       speed("speed", x_axis, end, a * end),
                                       spin("spin", y_axis, end, spun, 1 / b.radius),
                                       mode(0, end, rolls ? Mode::stick : Mode::slip),
                                       spin("spin half way", y_axis, std::floor(45 * end) / 90,
                                            exact::angular_acceleration(b) * std::floor(45 * end) / 90, 1 / b.radius),
                                       event_count(EventKind::breakaway, rolls ? 0 : 1),
                                       energy_balance(0.1)};
  return run(
      rolls ? "rolls" : "slips",
      [=] {
        RigidProblem p = ball(0.2, b.radius, b.beta, b.mu, end);
        p.gravity = tilted_gravity(b.slope);
        return p;
      },
      "L1: rolls iff tan(slope) <= (1 + 1/beta) mu, with a = g sin / (1 + beta); else a = g (sin - mu cos)",
      polynomial(end, 2), claims);
}

Case roll_down() {
  return {.id = "L1-E05",
          .title = "Ball down a slope: roll or slip",
          .statement = "A ball is let go on a slope of 0.5 or 0.9 rad.",
          .formula = "rolls iff tan(slope) <= (1 + 1/beta) mu",
          .runs = {down({0.03, 0.4, 0.5, 0.3, g}), down({0.03, 0.5, 0.9, 0.3, g})}};
}

Run orbits(const std::string& name, const exact::TurntableBall& b, double end) {
  const double mass = 0.1, r = b.radius;
  const Eigen::Vector2d start = exact::position(b, 0), spun = exact::spin(b, 0);
  std::vector<RigidClaim> claims;
  for (const double t : {std::floor(45 * end) / 90, end}) {
    const Eigen::Vector2d p = exact::position(b, t) - start, v = exact::velocity(b, t), w = exact::spin(b, t);
    const std::string at = fmt::format(" at t = {:.3g} s", t);
    claims.push_back(way("way along x" + at, x_axis, t, p.x(), start.norm()));
    claims.push_back(way("way along y" + at, y_axis, t, p.y(), start.norm()));
    claims.push_back(speed("speed along x" + at, x_axis, t, v.x(), b.velocity.norm()));
    claims.push_back(speed("speed along y" + at, y_axis, t, v.y(), b.velocity.norm()));
    claims.push_back(spin("spin about x" + at, x_axis, t, w.x(), 1 / r, b.rate));
    claims.push_back(spin("spin about y" + at, y_axis, t, w.y(), 1 / r, b.rate));
  }
  claims.push_back(event_count(EventKind::breakaway, 0));
  claims.push_back(energy_balance(0.01));
  return run(
      name,
      [=] {
        RigidProblem p = ball(mass, r, b.beta, 0.5, end);
        p.supports[0].turn = turning(z_axis, b.rate);
        p.X_WB.p.head<2>() = start;
        p.V_WB.v.head<2>() = b.velocity;
        p.V_WB.w.head<2>() = spun;
        return p;
      },
      "L1: v' = beta / (1 + beta) W z x v, a circle (Weltner 1979)", controlled(), claims);
}

Case turntable_ball() {
  const exact::TurntableBall whole{0.02, 0.4, 8, {0.05, -0.02}, {0.05, 0.1}};
  return {.id = "L1-E06",
          .title = "Ball on a turntable",
          .statement = "A ball rolls on a level plate that turns: its orbit is a circle of 7/2 of the plate's period.",
          .formula = "period 2 pi (1 + beta) / (beta W)",
          .runs = {orbits("5 rad/s", {}, 1.3), orbits("8 rad/s, a whole orbit", whole, exact::period(whole))}};
}

Case gutter_ball() {
  const exact::GutterBall b{};
  const double W = exact::swing_frequency(b), period = exact::swing_period(W, b.start), end = 1.25 * period;
  const double L = b.gutter - b.radius, v = exact::greatest_speed(b), mu = 0.5, x0 = L * std::sin(b.start);
  std::vector<RigidClaim> claims;
  for (const int k : {20, 50}) {
    const double a = exact::swing_from_rest(W, b.start, k / 90.);
    claims.push_back(way(fmt::format("way along x on frame {}", k), x_axis, k / 90., L * std::sin(a) - x0, L));
    claims.push_back(
        way(fmt::format("way along z on frame {}", k), z_axis, k / 90., L * (std::cos(b.start) - std::cos(a)), L));
  }
  claims.push_back(way("way at the bottom after 5/4 of a period", x_axis, end, -x0));
  claims.push_back(speed("greatest speed", x_axis, end, -v));
  claims.push_back(spin("spin at the bottom", y_axis, end, -v / b.radius, 1 / b.radius));
  claims.push_back(event_count(EventKind::breakaway, mu < exact::needed_friction(b) ? 1 : 0));
  claims.push_back(energy_balance(0.1));
  const Run rolls = run(
      "rolls",
      [=] {
        RigidProblem p = ball(0.1, b.radius, b.beta, mu, end);
        p.supports[0].surface = make_cylinder({0, 0, 0}, y_axis, b.gutter, true);
        p.X_WB.p = L * Eigen::Vector3d(std::sin(b.start), 0, -std::cos(b.start));
        return p;
      },
      "L1: a pendulum of frequency sqrt(g / ((1 + beta)(R - r)))", controlled(), claims);
  return {.id = "L1-E07",
          .title = "Ball rolling in a gutter",
          .statement = "A ball is let go at 1 rad from the bottom of a gutter and rolls to and fro.",
          .formula = "T = 4 K(sin(a0 / 2)) sqrt((1 + beta)(R - r) / g)",
          .runs = {rolls}};
}

}  // namespace

std::vector<Case> rigid_balls() {
  return {bowling_ball(), masse(), rolled_ball(), carried_ball(), roll_down(), turntable_ball(), gutter_ball()};
}

}  // namespace handhold::catalogue
