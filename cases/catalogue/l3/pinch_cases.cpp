// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/printed_problems.hpp"
#include "cases/catalogue/l3/families.hpp"

// An object between two fingers that slides, or might.

namespace handhold::catalogue {
namespace {

using closed_form::FrameOrder;
using closed_form::PinchFrame;
using closed_form::PrintedPinch;

const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();

/// The lag that carries the weight in stick.
double carrying_lag(const PrintedPinch& p) { return p.mass * p.gravity / (p.samples * p.face.gamma); }

/// The lag before the ray while sliding steadily, force first.
double sliding_lag(const PrintedPinch& p) { return carrying_lag(p) / p.face.friction.mu_dynamic; }

/// Of the speed. A rounding of the lag e moves the object by w e in the next frame, w = n mu_d gamma dt^2/m, a steady
/// slide by (1 - q) e; lag and speed keep sqrt(q) of it from frame to frame.
Limit pinch_limit(Ground ground, const PrintedPinch& p, double reach, double lag) {
  const double q = contraction(p.face);
  const double w = p.samples * p.face.friction.mu_dynamic * p.face.gamma * p.face.frame * p.face.frame / p.mass;
  return rounding_limit(places_on(ground, reach), lag, w / ((1 - q) * (1 - std::sqrt(q))),
                        "w of the lag goes into the speed, (1 - q) of it is the speed, 1/(1 - sqrt(q)) frames add up");
}

// --- L3-05 -----------------------------------------------------------------------------------------------------------

Run terminal_run(Ground ground, FrameOrder order) {
  const PrintedPinch p{.mass = 0.3, .order = order};
  const int frames = 400;  // q^200 = 6e-30
  Run run{.name = order == FrameOrder::force_first ? "force first" : "anchor first",
          .problem = [=] { return in_a_pinch(ground, p, {}, frames); }};
  PinchFrame early;
  for (int k = 0; k < 10; ++k) early = next_pinch(p, early);
  const double end = frames * p.face.frame, way = terminal_speed(p) * end;
  run.claims = {printed_claim("speed at frame 10", early.speed, "the frame map: force, velocity, ray, position",
                              speed_at(10 * p.face.frame, down), pinch_limit(ground, p, early.fall + 0.004, early.lag)),
                printed_claim("terminal speed", terminal_speed(p),
                              "m g eps/(n mu_d gamma dt (d + eps)), over q if the anchor goes first",
                              speed_at(end, down), pinch_limit(ground, p, way, sliding_lag(p))),
                printed_count("slipping samples", 16, "m g > n gamma mu_s d", count_at(end, Mode::slip))};
  return run;
}

// --- L3-06 -----------------------------------------------------------------------------------------------------------

constexpr int long_frames = 900;

Run rest_run(Ground ground) {
  const PrintedPinch p{.mass = 0.15};
  Run run{.name = "from rest", .problem = [=] { return in_a_pinch(ground, p, {.lag = carrying_lag(p)}, long_frames); }};
  const double end = long_frames * p.face.frame;
  const Limit rest = rounding_limit(places_on(ground, 0.005), 1, std::sqrt(double(long_frames)), "");
  run.claims = {printed_claim("fall in 10 s", 0, "m g = n gamma lag, and nothing moves", displacement_at(end, down),
                              {.value = rest.value,
                               .reason = "four roundings of places a frame, gathered by an undamped spring: sqrt(n)"}),
                printed_count("sticking samples", 16, "m g <= n gamma mu_s d", count_at(end, Mode::stick))};
  return run;
}

Run sliding_run(Ground ground, double mass, const std::string& name) {
  const PrintedPinch p{.mass = mass};
  const bool lasts = mass > sliding_mass(p);
  Run run{.name = name, .problem = [=] {
            PrintedProblem problem = in_a_pinch(ground, p, {.lag = sliding_lag(p), .slipping = true}, long_frames);
            problem.V_WO.v = terminal_speed(p) * down;
            return problem;
          }};
  run.claims = {printed_count("slides on for 10 s", lasts, "for ever iff m g > mu_d mu_s n gamma d",
                              none_of(EventKind::restick))};
  if (lasts)
    run.claims.push_back(printed_claim("speed", terminal_speed(p), "as L3-05",
                                       speed_at(long_frames * p.face.frame, down),
                                       pinch_limit(ground, p, terminal_speed(p) * 10, sliding_lag(p))));
  return run;
}

// --- L3-16 -----------------------------------------------------------------------------------------------------------

constexpr double opening_rate = 0.0002;  // [m/s]
constexpr int opening_frames = 1800;     // to empty fingers, at d = 0

Run opening_run(Ground ground) {
  const PrintedPinch p{.face = {.depth = 0.004}, .mass = 0.2};
  const double dt = p.face.frame, end = opening_frames * dt, creep = opening_creep(p, opening_rate);
  Run run{.name = "0.2 mm/s", .problem = [=] {
            PrintedProblem problem = in_a_pinch(ground, p, {.lag = carrying_lag(p)}, opening_frames);
            press(problem, [d = p.face.depth](double t) { return d - opening_rate * t; });
            return problem;
          }};
  PinchFrame map{.lag = carrying_lag(p)};
  PrintedPinch now = p;
  for (int k = 0; k < opening_frames; ++k) {
    now.face.depth = p.face.depth - opening_rate * k * dt;
    map = next_pinch(now, map);
  }
  // At d = 0: q = 0, and the speed follows the terminal one behind by m/(n mu_d gamma dt).
  const double stiffness = p.samples * p.face.gamma * p.face.friction.mu_dynamic;
  const double late = p.mass / (stiffness * dt), last_speed = p.mass * p.gravity / (stiffness * dt);
  run.claims = {
      printed_claim("slip onset", opening_onset(p, opening_rate), "m g = n gamma mu_s d(t), as Coulomb's",
                    time_of(EventKind::breakaway), {.value = dt, .reason = "the next frame sees it"}),
      printed_claim("fall until the fingers are open, by the map", map.fall, "the frame map of L3-05, d frame by frame",
                    displacement_at(end, down),
                    rounding_limit(creep, sliding_lag(p), 1 / std::sqrt(double(opening_frames)),
                                   "deviations of n frames' ways, at random")),
      printed_claim(
          "fall until the fingers are open, by the formula", creep, "m g eps/(n mu_d gamma dt r) ln((d_s + eps)/eps)",
          displacement_at(end, down),
          {.value = late * last_speed / creep,
           .relative = true,
           .reason = "quasi-steady: the speed is late by m/(n mu_d gamma dt) at most, times the last speed"})};
  return run;
}

}  // namespace

Case printed_heavy_pinch_case() {
  Case c = printed_case("L3-05", "Too heavy for the pinch, it creeps at a terminal speed");
  c.statement = "0.3 kg between two fingers of 8 samples, 2.5 mm deep: m g > 2 mu_s N.";
  c.formula = "v = m g eps/(n mu_d gamma dt (d + eps)); Coulomb: it falls with g - 2 mu_d N/m";
  for (const FrameOrder order : {FrameOrder::force_first, FrameOrder::anchor_first})
    for (Run& run : on_both([=](Ground g) { return terminal_run(g, order); })) c.runs.push_back(std::move(run));
  return c;
}

Case printed_two_states_case() {
  Case c = printed_case("L3-06", "Stuck and steadily sliding states coexist down to mu_d mu_s N");
  c.statement = "As L3-05 with 0.15 kg, and at 0.98 and 1.02 of the least mass that slides on.";
  c.formula = "holds iff m g <= n gamma mu_s d; slides on iff m g > mu_d n gamma mu_s d";
  for (Run& run : on_both(rest_run)) c.runs.push_back(std::move(run));
  const double least = closed_form::sliding_mass({});
  for (const auto& [mass, name] : {std::pair{0.15, "once sliding"}, std::pair{0.98 * least, "0.98 of the threshold"},
                                   std::pair{1.02 * least, "1.02 of the threshold"}})
    for (Run& run : on_both([=, m = mass, n = name](Ground g) { return sliding_run(g, m, n); }))
      c.runs.push_back(std::move(run));
  return c;
}

Case printed_opening_case() {
  Case c = printed_case("L3-16", "Opening fingers let the object creep out");
  c.statement = "0.2 kg between two fingers that open from 4 mm with 0.2 mm/s each. Planes only: it falls 1.7 m.";
  c.formula = "onset as Coulomb's; z = m g eps/(n mu_d gamma dt r) ln((d_s + eps)/eps)";
  c.runs = {opening_run(Ground::planes)};
  return c;
}

}  // namespace handhold::catalogue
