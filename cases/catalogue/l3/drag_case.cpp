// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/printed_problems.hpp"
#include "cases/catalogue/l3/families.hpp"

namespace handhold::catalogue {
namespace {

const Eigen::Vector3d along = Eigen::Vector3d::UnitX();
const closed_form::PrintedDrag drag{.face = {.depth = 0.004}};
constexpr double finger_speed = 0.3, first_speed = 0.2;  // [m/s]
constexpr int frames = 300;

double pressure() { return drag.samples * drag.face.gamma * drag.face.depth; }
double table_friction() { return drag.mu_table * (pressure() + drag.mass * drag.gravity); }
double steady_lag() { return table_friction() / (drag.samples * drag.face.gamma * drag.face.friction.mu_dynamic); }

/// The table carries weight and pressure and rubs against the motion, as long as the block goes forward.
PrintedProblem scene(Ground ground) {
  PrintedProblem p = ring_on_a_face(
      ground, drag.face, 0.003, [](double) { return 0.0; }, frames);
  p.mobility = Mobility::translation;
  p.inertia.mass = drag.mass;
  p.V_WO.v = first_speed * along;
  p.gravity.setZero();  // carried by the table
  p.load = [](double) { return Load{.force_W = {-table_friction(), 0, pressure()}}; };
  printed::Phalanx& finger = p.phalanges.front();
  finger.start.assign(8, {.lag_W = 1.2 * steady_lag() * along, .slipping = true});  // it comes to its steady value
  const double z = top_of(ground) - drag.face.depth;
  finger.pose = [z](double t) { return Pose{.p = {finger_speed * t, 0, z}}; };
  return p;
}

Run slides(Ground ground) {
  Run run{.name = "0.3 m/s", .problem = [=] { return scene(ground); }};
  const double end = frames * drag.face.frame, speed = finger_speed - drag_lag_speed(drag);
  // As in a pinch: w of a lag's rounding goes into the speed, (1 - q) of the lag is what it lags behind in a frame.
  const closed_form::PrintedFace& f = drag.face;
  const double q = contraction(f), kept = 1 / (1 - std::sqrt(q)), behind = drag_lag_speed(drag) / speed;
  const double w = drag.samples * f.friction.mu_dynamic * f.gamma * f.frame * f.frame / drag.mass;
  const double reach = places_on(ground, finger_speed * end);
  const Limit of_lag = rounding_limit(reach, steady_lag(), kept, "1/(1 - sqrt(q)) frames add up");
  const Limit of_speed = rounding_limit(reach, steady_lag(), w / (1 - q) * kept * behind,
                                        "w of the lag goes into the speed, for 1/(1 - sqrt(q)) frames");
  run.claims = {printed_claim("speed of the block", speed, "V - mu_t (N + m g) eps/(n mu_d gamma dt (d + eps))",
                              speed_at(end, along), of_speed),
                printed_claim("lag of the samples", steady_lag(), "n mu_d gamma s = mu_t (N + m g)",
                              {.kind = Measure::Kind::lag, .axis = along, .at = end}, of_lag),
                printed_count("slides on", 1, "mu_t (N + m g) > mu_d mu_s N", none_of(EventKind::restick))};
  return run;
}

}  // namespace

Case printed_drag_case() {
  Case c = printed_case("L3-17", "A block dragged by a finger on top lags behind by a constant speed");
  c.statement = "A block of 0.2 kg on a table (mu 0.2); a finger of 8 samples, 4 mm deep, moves over it at 0.3 m/s.";
  c.formula = "V - v = mu_t (N + m g) eps/(n mu_d gamma dt (d + eps)); rigid Coulomb: it sticks or stays";
  c.runs = on_both(slides);
  return c;
}

}  // namespace handhold::catalogue
