// SPDX-License-Identifier: GPL-3.0-or-later
// H03 to H06: bodies that come to each other through the air.

#include <cmath>
#include <numbers>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/bodies.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::Bounce;
using closed_form::Strike;
using closed_form::Sweep;

constexpr int samples = 4;
constexpr double coarse = 1.0 / 256;  // of voxels: the band is 47 mm, room for soft springs [m]
constexpr double second_order = 2;    // what a first-order shift leaves out is less than the shift
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

/// A cube; the one above brings four samples on its lower face.
Body cube(const char* name, double length, double mass, Mobility mobility, double bottom, double spacing = coarse) {
  Body body = block(Eigen::Vector3d::Constant(length), spacing, mass, {0.5, 0.5});
  body.name = name;
  body.mobility = mobility;
  body.X_WO.p = (bottom + length / 2) * up;
  return body;
}

void touch_below(Body& body, double length) {
  body.samples_O = ring(-length / 2 * up, up, Eigen::Vector3d::UnitX(), 0.004, samples);
}

Claim event_claim(const std::string& quantity, EventKind kind, int n, double truth, const std::string& source,
                  double speed, const Limit& stepped) {
  return {.quantity = quantity,
          .unit = "s",
          .truth = truth,
          .source = source,
          .measure = {.kind = Measure::Kind::event_time, .event = kind, .occurrence = 1 + (n - 1) * samples, .body = 0},
          .controlled = absolute_controlled_limit(1 + 1 / speed, "of places, over the speed of the crossing"),
          .stepped = stepped};
}

Scene strike_scene(const Strike& s, double duration) {
  Scene scene;
  scene.name = "H03 strike";
  scene.duration = duration;
  scene.body_contact = {.stiffness = s.stiffness / samples, .damping = 0};
  Body struck = cube("struck", 4 * edge, s.mass_a, Mobility::translation, -4 * edge);
  Body striker = cube("striker", edge, s.mass_b, Mobility::translation, s.gap);
  struck.V_WO.v = s.speed_a * up;
  striker.V_WO.v = s.speed_b * up;
  touch_below(striker, edge);
  scene.bodies = {struck, striker};
  return scene;
}

Scene bounce_scene(const Bounce& b, double duration) {
  Scene scene;
  scene.name = "H04 bounce";
  scene.duration = duration;
  scene.body_contact = {.stiffness = b.stiffness / samples, .damping = 0};
  Body ground = cube("ground", 4 * edge, 1, Mobility::fixed, -4 * edge);
  Body falling = cube("falling", edge, b.mass, Mobility::translation, b.gap);
  touch_below(falling, edge);
  scene.bodies = {ground, falling};
  return scene;
}

constexpr double pressed_mass = 0.02, push = 10, pressed_gap = 6e-4;  // [kg], [N], [m]

Scene pressed_scene(double duration) {
  Scene scene;
  scene.name = "H05 pressed";
  scene.duration = duration;
  Body ground = cube("ground", edge, 1, Mobility::fixed, -edge, voxel);
  Body pressed = cube("pressed", edge, pressed_mass, Mobility::translation, pressed_gap, voxel);
  pressed.load = [](double) -> Load { return {.force_W = -push * up}; };
  touch_below(pressed, edge);
  scene.bodies = {ground, pressed};
  return scene;
}

const Eigen::Vector3d bar{3 * edge, edge / 4, edge / 4};

Sweep sweep() { return {.arm = bar.x() / 2, .wall = bar.x() / 2 * std::cos(0.3), .start = 1, .spin = 8}; }

/// The bar turns about +z towards +x, where the wall is.
Scene sweep_scene(const Sweep& s, double duration) {
  Scene scene;
  scene.name = "H06 sweep";
  scene.duration = duration;
  scene.gravity.setZero();
  Body wall = cube("wall", 4 * edge, 1, Mobility::fixed, -2 * edge);
  wall.X_WO.p.x() = s.wall + 2 * edge;
  Body turning = block(bar, voxel, 0.1, {0.5, 0.5});
  turning.name = "bar";
  turning.X_WO.R = Eigen::AngleAxisd(-s.start, up);
  turning.V_WO.w = s.spin * up;
  turning.samples_O = {Eigen::Vector3d(s.arm, 0, 0)};
  scene.bodies = {wall, turning};
  return scene;
}

}  // namespace

Case struck_case() {
  const Strike s;
  const double end = 36.0 / 90;
  const double kick = s.mass_b / (s.mass_a + s.mass_b) * closing_speed(s);
  Limit speed = implicit_ring_limit(kick, strike_frequency(s), parting_time(s) - strike_time(s));
  speed.per_step *= second_order;
  speed.reason += ", twice that for what is of second order";
  Limit way = euler_bias_limit(s.gravity * end + 2 * kick);
  way.per_step += speed.per_step * (end - strike_time(s));
  way.reason += "; and the error of the speed since the touch";
  Run run{.name = "struck", .problem = [=] { return strike_scene(s, end); }};
  run.claims = {event_claim("touch", EventKind::touch, 1, strike_time(s), "L1 = L2: gap/w, gravity is common",
                            closing_speed(s), event_limit()),
                event_claim("parting", EventKind::release, 1, parting_time(s), "L2: half a period of the spring later",
                            closing_speed(s), event_limit(2, "and begins up to a sub-step off")),
                {.quantity = "speed of the struck one",
                 .unit = "m/s",
                 .truth = speed_of_a(s, end),
                 .source = "L1 = L2: v_a - g t - 2 m_b w/(m_a + m_b)",
                 .measure = {.kind = Measure::Kind::speed, .axis = up, .at = end, .body = 0},
                 .controlled = controlled_limit(),
                 .stepped = speed},
                {.quantity = "way of the struck one",
                 .unit = "m",
                 .truth = distance_of_a(s, end),
                 .source = "L2: free fall, half the kick during contact, all of it after",
                 .measure = {.kind = Measure::Kind::displacement, .axis = up, .at = end, .body = 0},
                 .controlled = controlled_limit(),
                 .stepped = way}};
  return {
      .id = "H03",
      .title = "A falling block struck by a faster one",
      .truth_level = "L2",
      .statement = "A 0.3 kg block falls; 0.1 kg come from above, 0.3 m/s faster.",
      .formula = "touch gap/w; contact pi/w_c, w_c^2 = K (1/m_a + 1/m_b); then the closing speed is turned round",
      .note = "K = 17 N/m (4 samples), undamped, rotation locked. Speed and energy are those of an elastic blow in L1.",
      .runs = {run}};
}

Case bounce_case() {
  const Bounce b;
  const double end = 54.0 / 90, first = landing_time(b), speed = landing_speed(b);
  // The implicit step damps with h K: what it takes of the landing speed, a unit of step.
  const double lost = b.stiffness * squared_speed_in_contact(b) / (b.mass * speed);
  const double later = second_order * lost * 2 / b.gravity;
  // It lets the sag m g/K that the swing goes about fade with h w^2/2, so that the surface is reached later.
  const double lifted = second_order * b.gravity * contact_time(b) / (2 * speed);
  Run run{.name = "bounces", .problem = [=] { return bounce_scene(b, end); }};
  const std::string early = "free fall is half a step early";
  run.claims = {
      event_claim("landing", EventKind::touch, 1, first, "L1 = L2: sqrt(2 gap/g)", speed, event_limit(1.5, early)),
      event_claim("take-off", EventKind::release, 1, first + contact_time(b), "L2: + 2 (pi - atan(v w/g))/w", speed,
                  event_limit(1.5 + lifted, early + "; twice g t_c/(2 v) by which the damping h K of the step delays")),
      event_claim("second landing", EventKind::touch, 2, first + contact_time(b) + flight_time(b), "L2: + 2 v/g", speed,
                  {.per_step = 1.51 + lifted + later,
                   .reason = "as the take-off, and twice the flight that is lost with the speed which the step's own "
                             "damping h K takes: 2 K int d'^2 dt/(m v g) a step"})};
  return {.id = "H04",
          .title = "A block dropped on another: period of bouncing",
          .truth_level = "L2",
          .statement = "A 0.1 kg block falls 10 mm on a fixed one and bounces on the undamped spring between them.",
          .formula = "v = sqrt(2 g gap); contact 2 (pi - atan(v w/g))/w, flight 2 v/g, for ever",
          .note = "K = 90 N/m (4 samples), rotation locked.",
          .runs = {run}};
}

Case pressed_case() {
  const double end = 9.0 / 90, force = push + pressed_mass * 9.81;
  Run run{.name = "is pressed down", .problem = [=] { return pressed_scene(end); }};
  run.claims = {
      event_claim("touch", EventKind::touch, 1, std::sqrt(2 * pressed_gap * pressed_mass / force),
                  "L1 = L2: sqrt(2 gap m/F)", std::sqrt(2 * pressed_gap * force / pressed_mass), event_limit()),
      {.quantity = "force at rest",
       .unit = "N",
       .truth = -force,
       .source = "L1 = L2: F + m g",
       .measure = {.kind = Measure::Kind::force, .axis = up, .at = end, .body = 0, .owner = 1},
       .controlled = {.per_accuracy = 8e4,
                      .reason = "the integrator's accuracy of places, where the springs have 8e4 N/m"},
       .stepped = {.value = 1e-11,
                   .relative = true,
                   .reason = "rest does not depend on the step, and nothing of the blow is left: the solve, to 1e-13 "
                             "of a momentum of 10 m/s a step, and rounding of places under 8e4 N/m"}}};
  return {.id = "H05",
          .title = "A light block pressed on another: the first touch",
          .truth_level = "L1 = L2",
          .statement = "A 20 g block, 0.6 mm above a fixed one, is pushed down with 10 N.",
          .formula = "touch sqrt(2 gap m/(F + m g)); at rest the force is F + m g",
          .note = "In the step in which it touches it moves by eight voxels although it was at rest before.",
          .runs = {run}};
}

Case sweep_case() {
  const Sweep s = sweep();
  const double end = 10.0 / 90, before = 6.0 / 90;
  Run run{.name = "meets the wall", .problem = [=] { return sweep_scene(s, end); }};
  run.claims = {event_claim("touch", EventKind::touch, 1, reach_time(s), "L1 = L2: (start - acos(wall/arm))/spin",
                            s.arm * s.spin * std::sin(std::acos(s.wall / s.arm)), event_limit()),
                {.quantity = "angle before it",
                 .unit = "rad",
                 .truth = s.spin * before,
                 .source = "L1 = L2: a free spin about a principal axis",
                 .measure = {.kind = Measure::Kind::rotation, .axis = up, .at = before, .body = 1},
                 .controlled = controlled_limit(),
                 .stepped = {.value = 1e-12, .reason = "exact turns: rounding of some 30 of them"}}};
  return {.id = "H06",
          .title = "The end of a spinning bar meets a wall",
          .truth_level = "L1 = L2",
          .statement = "A bar turns about its middle with 8 rad/s; its end reaches a fixed block's face.",
          .formula = "t = (start - acos(wall/arm))/spin",
          .note = "Nothing but the spin brings the two together: no centre moves.",
          .runs = {run}};
}

}  // namespace handhold::catalogue
