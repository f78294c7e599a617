// SPDX-License-Identifier: GPL-3.0-or-later
// G03, G12: one contact moved by the hand on an object that stays, so that nothing but the element answers.

#include <cmath>
#include <numbers>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/jenkins_loop.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 8;
constexpr double stiffness = 100, total_stiffness = samples * stiffness, normal_force = 2;
constexpr double frequency = 2 * std::numbers::pi * 90 / 40;  // a quarter of a period is ten frames
const Eigen::Vector3d along = Eigen::Vector3d::UnitX();

double frame(int n) { return n / 90.0; }

/// A ring of 4 mm on a palm that starts at `start` along x and moves by `path`, under a block that is held fast.
Scene scene(const std::string& name, const Friction& friction, double start, const Path& path, double duration) {
  Scene scene;
  scene.name = name;
  scene.duration = duration;
  scene.contact = {.stiffness = stiffness, .damping = 0};
  Body body = block({edge, edge, edge}, voxel, 0.2, friction);
  body.mobility = Mobility::fixed;
  body.X_WO.p.z() = edge / 2 - normal_force / total_stiffness;
  scene.bodies = {body};
  const auto points = ring(start * along, Eigen::Vector3d::UnitZ(), along, 0.004, samples);
  scene.hands = {hand_of({{palm, points, std::vector<SampleStart>(points.size()), path}}, duration)};
  return scene;
}

Claim force(int at_frame, double truth, const std::string& quantity, const Limit& stepped) {
  return claim(quantity, truth, "L2: Jenkins element", force_at(frame(at_frame), along), controlled_limit(), stepped);
}

Claim dissipated(int at_frame, double truth, const std::string& quantity, const Limit& controlled,
                 const Limit& stepped) {
  return claim(quantity, truth, "L2: 4 mu N (A - mu N/K) a cycle, a quarter of it to the first extreme",
               {.kind = Measure::Kind::dissipated, .at = frame(at_frame)}, controlled, stepped);
}

/// The cubic spline through the hand, sampled at 2 kHz, is off by (ω Δ)⁴/384 of the amplitude. A hand that is known on
/// frames only passes the extreme by some (ω dt)⁶/32 of it between them, but is back before the first sub-step ends.
double spline_error(double amplitude) { return amplitude * std::pow(frequency / 2000, 4) / 384; }

/// No mass, a normal force that does not change: the step is exact on frames.
Limit exact_at_frames(double size, double slack) {
  return {.value = 1e-12 * size + slack,
          .reason =
              "no mass and a constant N: exact on frames but for rounding and the spline of the hand's sine, "
              "(w D)^4/384 of it"};
}

Path swinging(double amplitude) {
  return [amplitude](double t) -> Eigen::Vector3d { return amplitude * std::sin(frequency * t) * along; };
}

Run slipping_loop() {
  const closed_form::JenkinsLoop loop{.stiffness = total_stiffness, .normal_force = normal_force, .mu = 0.5};
  const double A = loop.amplitude, end = frame(50), yield = greatest_force(loop);
  Run run{.name = "A = 4 mm yields", .problem = [=] {
            return scene("G03 loop", {loop.mu, loop.mu}, 0, swinging(A), end);
          }};
  const double elastic = A * std::sin(frequency * frame(12));  // on the way back, before it yields
  const double first = loss_per_cycle(loop) / 4;
  const Limit at_yield = exact_at_frames(yield, 0);
  const Limit lost = exact_at_frames(first, 6 * yield * spline_error(A));
  const double back = A - reversal_distance(loop);
  const double hand_speed = frequency * std::sqrt(A * A - back * back);
  run.claims = {
      force(10, yield, "force at +A", at_yield),
      force(12, returning_force(loop, elastic), "force after the reversal",
            exact_at_frames(yield, total_stiffness * spline_error(A))),
      force(30, -yield, "force at -A", at_yield),
      dissipated(10, first, "loss to the first extreme", controlled_limit(), lost),
      dissipated(50, 5 * first, "loss after a full cycle more", controlled_limit(), lost),
      {.quantity = "displacement at the reversal's slip",
       .unit = "m",
       .truth = -back,  // of the object against the hand
       .source = "L2: 2 mu N/K back from the extreme",
       .measure = {.kind = Measure::Kind::displacement,
                   .event = EventKind::breakaway,
                   .occurrence = samples + 1,
                   .axis = along},
       .controlled = absolute_controlled_limit(),
       .stepped = {.value = spline_error(A),
                   .per_step = 1.3 * hand_speed,
                   .reason = "shows at the end of its sub-step: times the hand's speed, which grows by up to 30 % "
                             "until then"}}};
  return run;
}

Run elastic_loop() {
  const closed_form::JenkinsLoop loop{
      .stiffness = total_stiffness, .normal_force = normal_force, .mu = 0.5, .amplitude = 0.001};
  const double end = frame(50);
  Run run{.name = "A = 1 mm stays elastic", .problem = [=] {
            return scene("G03 elastic", {loop.mu, loop.mu}, 0, swinging(loop.amplitude), end);
          }};
  const double largest = greatest_force(loop);
  run.claims = {
      force(10, largest, "force at +A", exact_at_frames(largest, total_stiffness * spline_error(loop.amplitude))),
      force(50, largest, "force at +A, a cycle later",
            exact_at_frames(largest, total_stiffness * spline_error(loop.amplitude))),
      dissipated(50, 0, "loss", exact_limit(), exact_limit())};
  return run;
}

}  // namespace

Case jenkins_loop_case() {
  return {
      .id = "G03",
      .title = "Jenkins element: cyclic tangential displacement, hysteresis loop",
      .truth_level = "L2",
      .statement =
          "A palm presses with 2 N on a block that is held fast and moves sideways as A sin(14.1 t); mu = 0.5.",
      .formula =
          "loss 4 mu N (A - mu N/K) a cycle if A > mu N/K, else none; force within +-mu N; slip 2 mu N/K after "
          "a reversal",
      .note =
          "K = 800 N/m of 8 samples, undamped. Forces and losses are read off the recorded contacts and energy book.",
      .runs = {slipping_loop(), elastic_loop()}};
}

Case chatter_case() {
  constexpr Friction friction{.mu_static = 0.5, .mu_dynamic = 0.4};
  constexpr double distance = 0.0201;
  const double end = frame(45), speed = distance / end;
  const Path path = [=](double t) -> Eigen::Vector3d { return speed * t * along; };
  Run run{.name = "dragged by 20.1 mm",
          .problem = [=] { return scene("G12 drag", friction, -distance / 2, path, end); }};
  const double kinetic = friction.mu_dynamic * normal_force;
  const Limit rounding{.value = 1e-12, .reason = "no mass, constant N and a hand at constant speed: rounding"};
  const double highest = friction.mu_static * normal_force;
  const double work = 0.5 * highest * highest / total_stiffness + kinetic * (distance - highest / total_stiffness);
  const double onset = friction.mu_static * normal_force / total_stiffness / speed;
  run.claims = {
      force(2, total_stiffness * speed * frame(2), "force in stick, t = 2/90 s", rounding),
      claim("breakaway", onset, "L2: mu_s N/K of drag", time_of(EventKind::breakaway), controlled_limit(),
            event_limit()),
      force(10, kinetic, "force in slip, t = 1/9 s", rounding),
      force(31, kinetic, "force in slip, t = 31/90 s", rounding),
      force(45, kinetic, "force in slip, t = 0.5 s", rounding),
      claim("slip events, one a sample", samples,
            "L2: the state flag keeps slip until the anchor stands; without one 75 times as many (saw-tooth of "
            "period (mu_s - mu_d) N/K)",
            {.kind = Measure::Kind::event_count, .event = EventKind::breakaway}, exact_limit(), exact_limit()),
      yes_or_no("never sticks again", true, "L2: as above", none_of(EventKind::restick)),
      {.quantity = "loss",
       .unit = "J",
       .truth = work - 0.5 * kinetic * kinetic / total_stiffness,
       .source =
           "L2: work of the hand, mu_s^2 N^2/(2 K) + mu_d N (D - mu_s N/K), less the energy mu_d^2 N^2/(2 K) that "
           "the springs keep",
       .measure = {.kind = Measure::Kind::dissipated, .at = end},
       .controlled = controlled_limit(),
       .stepped = {.value = 0.5 * (highest - kinetic) * (highest - kinetic) / total_stiffness,
                   .per_step = (highest - kinetic) * speed,
                   .reason =
                       "the implicit step goes to the kinetic lag at once, which leaves (mu_s - mu_d)^2 N^2/(2 K) "
                       "out of the book, and does so up to one sub-step early: times the drop of the force and "
                       "the hand's speed"}}};
  return {
      .id = "G12",
      .title = "Slip with a state flag does not chatter between the cones",
      .truth_level = "L2",
      .statement = "A palm presses with 2 N on a block that is held fast and drags by 20.1 mm; mu_s = 0.5, mu_d = 0.4.",
      .formula =
          "with a flag F = mu_d N while sliding; a law that tests the mu_s cone every step makes a saw-tooth "
          "mu_d N to mu_s N, mean 0.9 N",
      .note = "K = 800 N/m of 8 samples, undamped, constant speed. Counted: one breakaway a sample.",
      .runs = {run}};
}

}  // namespace handhold::catalogue
