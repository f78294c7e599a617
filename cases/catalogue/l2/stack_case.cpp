// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/bodies.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::Stack;

constexpr int samples = 8, lower = 0, upper = 1;
const Eigen::Vector3d along = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitZ();

/// Of the upper block that gives `pair` together with a lower one of friction `below`.
Friction partner(double below, double pair) { return {pair * pair / below, pair * pair / below}; }

Scene scene(const Stack& s, double duration) {
  Scene scene;
  scene.name = "H02 stack on a palm";
  scene.duration = duration;
  scene.contact = {.stiffness = s.stiffness_palm / samples, .damping = 0};
  scene.body_contact = {.stiffness = s.stiffness_pair / samples, .damping = 0};
  Body below = block({3 * edge, edge, edge / 2}, 2 * voxel, s.mass_lower, {s.mu_palm, s.mu_palm});
  Body above = block({edge, edge, edge / 2}, 2 * voxel, s.mass_upper, partner(s.mu_palm, s.mu_pair));
  const double weight = s.mass_upper * s.gravity, depth = weight / s.stiffness_pair;
  below.name = "lower";
  below.X_WO.p = (edge / 4 - (weight + s.mass_lower * s.gravity) / s.stiffness_palm) * up;
  below.V_WO.v = lower_start_speed(s) * along;
  above.name = "upper";
  above.X_WO.p = below.X_WO.p + (edge / 2 - depth) * up;
  above.V_WO.v = upper_start_speed(s) * along;
  above.samples_O = ring(-edge / 4 * up, up, along, 0.01, samples);
  for (Body* body : {&below, &above}) body->mobility = Mobility::translation;
  scene.bodies = {below, above};
  const double jerk = s.jerk;
  const Path path = [jerk](double t) -> Eigen::Vector3d { return jerk * t * t * t / 6 * along; };
  scene.hands = {hand_of({palm_patch({}, path)}, duration)};
  return scene;
}

/// The implicit step's acceleration is that of the step's start, one step late; the hand's path between frames, a cubic
/// through rates of second order (off by j dt²/3, dt four steps), leaves half a step more.
Limit onset_limit() {
  return event_limit(2.5, "the step's acceleration is that of its start, and the hand's between frames a guess");
}

/// Breakaways of the pair, or of the lower block on the palm.
Measure breakaway(Measure::Kind kind, bool pair) {
  Measure measure{.kind = kind, .event = EventKind::breakaway, .body = lower};
  if (pair) measure.owner = upper;
  if (!pair) measure.phalanx = palm;
  return measure;
}

Claim onset_claim(const Stack& s, bool pair) {
  return claim(
      "onset", onset(s), "L1 = L2: mu g/j", breakaway(Measure::Kind::event_time, pair),
      absolute_controlled_limit(
          1 + (pair ? s.stiffness_pair / s.mass_upper : s.stiffness_palm / (s.mass_lower + s.mass_upper)) / s.jerk,
          "K times that of places, over the m j a second with which the load grows"),
      onset_limit());
}

Claim holds_claim(bool pair) {
  return yes_or_no(pair ? "the pair holds" : "the palm holds", true, "L2: its load stays below its cone",
                   breakaway(Measure::Kind::no_event, pair));
}

Claim slip_claim(const Stack& s, bool pair, double end) {
  const double after = end - onset(s), truth = pair ? upper_slip(s, end) : lower_slip(s, end);
  // The spring's load is a step late, so that the lag is short by as much; the half step that a constant acceleration
  // gains since the onset is the half step by which the palm's speed was late at it. What is left is an onset late by
  // 2.5 steps, of second order since the acceleration does not jump.
  constexpr double late = 2.5, step = 1.0 / 360;
  const double lag = -(pair ? upper_start_speed(s) : lower_start_speed(s));
  return claim(pair ? "slip of the upper block" : "slip of the lower block", truth,
               pair ? "L2: constant acceleration mu g from the onset on"
                    : "L2: the centre of mass has mu g; the upper spring swings about its load",
               {.kind = Measure::Kind::displacement, .axis = along, .at = end, .body = pair ? upper : lower},
               absolute_controlled_limit(),
               {.per_step = lag + 0.5 * s.jerk * late * late * step * after,
                .reason = "the lag of springs whose load is a step late, and an onset late by 2.5 steps: j (2.5 h)^2/2 "
                          "of speed"});
}

Run run(const std::string& name, const Stack& s, bool pair, double end) {
  return {.name = name,
          .problem = [=] { return scene(s, end); },
          .claims = {onset_claim(s, pair), holds_claim(!pair), slip_claim(s, pair, end)}};
}

}  // namespace

Case stack_case() {
  return {.id = "H02",
          .title = "A stack on a palm: which interface slips first",
          .truth_level = "L1 = L2",
          .statement =
              "0.2 kg on 0.3 kg on a palm whose acceleration grows with 10 m/s^3; mu = 0.8 below and 0.4 between the "
              "blocks, or 0.3 and 0.6.",
          .formula = "the interface with the smaller mu slips at mu g/j; what slides on it has mu g",
          .note =
              "K = 4000 N/m each (8 samples), undamped; the blocks start with the speeds at which both springs load "
              "evenly, so that nothing swings before the onset.",
          .runs = {run("the pair slips", {}, true, 63.0 / 90),
                   run("the palm slips", {.mu_palm = 0.3, .mu_pair = 0.6}, false, 45.0 / 90)}};
}

}  // namespace handhold::catalogue
