// SPDX-License-Identifier: GPL-3.0-or-later
// X01 to X09: one sample of a finger at the edges and corners of a body that does not move.

#include <cmath>
#include <functional>
#include <numbers>

#include <fmt/format.h>

#include "cases/catalogue/families.hpp"
#include "cases/catalogue/scenes/edge_scenes.hpp"
#include "cases/closed_form/edge.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::EdgeContact;
using Eigen::Vector3d;

constexpr double mm = 1e-3, degree = std::numbers::pi / 180;
constexpr double voxel_size = 1 * mm;
constexpr double largest_acceleration = 0.1;  // of the finger on its ways [m/s²]
const EdgeContact contact{};

/// The last frame of the rest after the n-th way.
double rest_after(const EdgeScene& edge, std::size_t way) { return std::floor(90 * edge.arrivals[way] + 1e-9) / 90; }

Limit controlled_force() {
  return absolute_controlled_limit(contact.stiffness, "a force follows its sample's place by k = 100 N/m");
}

/// One component of the force on the body, at rest.
Claim force(const std::string& quantity, const Vector3d& axis, double t, double truth, double scale) {
  return {.quantity = quantity,
          .unit = "N",
          .truth = truth,
          .source = "L2: k (p - C), at rest",
          .measure = {.kind = Measure::Kind::force, .axis = axis, .at = t},
          .controlled = controlled_force(),
          .stepped = {.value = 1e-9,
                      .reason = "at rest a step is exact: k times the rounding of places of 60 mm, and what the "
                                "damper's share of a step, c/(k h + c), leaves after a rest of 4 frames"},
          .scale = scale};
}

/// The same where it is friction's, of a finger that slid until it came to rest after `way` in `duration`.
Claim friction(const std::string& quantity, const Vector3d& axis, double t, double truth, double scale, double way,
               double duration) {
  Claim claim = force(quantity, axis, t, truth, scale);
  const double jerk = 60 * way / std::pow(duration, 3);  // at the end of a way of minimum jerk
  claim.stepped.value += contact.stiffness * jerk / (12 * std::pow(90, 3));
  claim.stepped.reason +=
      "; between frames the hand is known to a dt^2/12, a = (60 D/T^3) dt in its last one: it may stick that early";
  return claim;
}

/// How far the finger has come along `axis` when an event happens. It moves at `speed` then.
Claim way_at(const std::string& quantity, EventKind kind, int n, const Vector3d& axis, double truth, double speed,
             const std::string& source) {
  return {.quantity = quantity,
          .unit = "m",
          .truth = truth,
          .source = source,
          .measure = {.kind = Measure::Kind::displacement, .event = kind, .occurrence = n, .axis = -axis},
          .controlled = absolute_controlled_limit(10, "and the event is found to ten times that"),
          .stepped = {.value = largest_acceleration / (12 * 90 * 90),
                      .per_step = 1.01 * speed,
                      .reason = "the event shows at the end of its sub-step, speed times h later, + 1 %; between "
                                "frames the hand is known to a dt^2/12"}};
}

Claim count(EventKind kind, const std::string& quantity, int truth) {
  return {.quantity = quantity,
          .truth = double(truth),
          .source = "L2",
          .measure = {.kind = Measure::Kind::event_count, .event = kind},
          .controlled = exact_limit(),
          .stepped = exact_limit(),
          .scale = 1};
}

/// When the finger, on its way between `from` and `to` [s], comes to x = `place(speed)`.
double time_of(const EdgeScene& edge, double from, double to, const std::function<double(double speed)>& place) {
  for (int i = 0; i < 100; ++i) {
    const double t = 0.5 * (from + to);
    (edge.path(t).x() < place(edge.velocity(t).x()) ? from : to) = t;
  }
  return 0.5 * (from + to);
}

Run run_of(const std::string& name, const std::function<EdgeScene()>& make, std::vector<Claim> claims) {
  return {.name = name, .problem = [make]() -> Problem { return make().scene; }, .claims = std::move(claims)};
}

Run dragged(double turn) {
  const double depth = 2 * mm;
  const auto make = [=] { return dragged_over(turn, depth, voxel_size); };
  const EdgeScene edge = make();
  const double t = time_of(edge, edge.arrivals[0], edge.arrivals[1],
                           [=](double speed) { return closed_form::leaves_convex_edge(contact, depth, turn, speed); });
  const double way = (edge.path(t) - edge.path(0)).x();
  return run_of(fmt::format("turns by {:.0f} degrees", turn / degree), make,
                {way_at("way of the finger when it is let go", EventKind::release, 1, Vector3d::UnitX(), way,
                        edge.velocity(t).x(), "L2: x = max(mu_d d, d cot a - c V/k) beyond the edge"),
                 count(EventKind::release, "releases", 1)});
}

Run pressed(double beside, double tilt) {
  const double depth = 4 * mm;
  const auto make = [=] { return pressed_beside(beside, depth, tilt, voxel_size); };
  const Eigen::Vector2d f = closed_form::pressed(contact, depth, tilt);
  const double t = rest_after(make(), 0), scale = contact.stiffness * depth;
  return run_of(
      fmt::format("{:.1f} mm beside it, at {:.0f} degrees", beside / mm, tilt / degree), make,
      {friction("force across the edge", Vector3d::UnitX(), t, f.x(), scale, (depth + 1 * mm) / std::cos(tilt), 0.5),
       force("force into the face", Vector3d::UnitZ(), t, f.y(), scale)});
}

Case leaves_convex_edge_case() {
  return {.id = "X01",
          .title = "A finger dragged over a convex edge",
          .truth_level = "L2",
          .statement = "A sample 2 mm deep is dragged 10 mm over an edge that turns down by 60, 90 or 110 degrees.",
          .formula = "let go at x = max(mu_d d, d cot a - c V/k) beyond the edge",
          .note = "k = 100 N/m, c = 0.05 N s/m, mu 0.5/0.4, one sample, no gravity, the body fixed.",
          .runs = {dragged(90 * degree), dragged(60 * degree), dragged(110 * degree)}};
}

Case pressed_beside_edge_case() {
  return {.id = "X02",
          .title = "A finger pressed beside a convex edge",
          .truth_level = "L2",
          .statement = "A sample is pressed 4 mm deep 0.1 or 0.4 mm beside a right-angled edge, straight or tilted.",
          .formula = "f_x = -k d tan(th) where it sticks (tan th <= mu_s), else -mu_d k d; f_z = -k d",
          .note = "As X01. How near the edge is does not matter to the law.",
          .runs = {pressed(0.1 * mm, 0), pressed(0.1 * mm, 20 * degree), pressed(0.4 * mm, 35 * degree)}};
}

Case held_beyond_edge_case() {
  const auto make = [] { return led_outside(voxel_size); };
  const EdgeScene edge = make();
  const Vector3d out = closed_form::held(contact, {1.5 * mm, 0, -4 * mm});
  const double scale = out.norm();
  return {.id = "X03",
          .title = "A finger that sticks is led beyond the edge and back",
          .truth_level = "L2",
          .statement = "It sticks 0.5 mm before a right-angled edge, 4 mm deep; it is led 1 mm beyond it, and back.",
          .formula = "f = k (p - C) all the time: f_x = k x, f_z = -k d",
          .note = "As X01. Its anchor does not move, so that the edge is of no importance.",
          .runs = {run_of("out and back", make,
                          {force("f_x beyond the edge", Vector3d::UnitX(), rest_after(edge, 1), out.x(), scale),
                           force("f_z beyond the edge", Vector3d::UnitZ(), rest_after(edge, 1), out.z(), scale),
                           force("f_x when back", Vector3d::UnitX(), rest_after(edge, 2), 0, scale),
                           force("f_z when back", Vector3d::UnitZ(), rest_after(edge, 2), out.z(), scale),
                           count(EventKind::release, "releases", 0)})}};
}

Case back_in_case() {
  const auto make = [] { return back_in(voxel_size); };
  const EdgeScene edge = make();
  const Vector3d f = closed_form::held(contact, {-2 * mm, 0, 0});
  return {.id = "X04",
          .title = "A finger let go at an edge comes back through the side",
          .truth_level = "L2",
          .statement = "Dragged over a right-angled edge and let go there, it comes back 2 mm deep into the side face.",
          .formula = "f = (-k 2 mm, 0, 0): a new touch, on the face that it crosses",
          .note = "As X01.",
          .runs = {run_of("back in", make,
                          {force("f_x at the end", Vector3d::UnitX(), rest_after(edge, 2), f.x(), f.norm()),
                           force("f_z at the end", Vector3d::UnitZ(), rest_after(edge, 2), f.z(), f.norm()),
                           count(EventKind::touch, "touches", 2)})}};
}

Case hollow_edge_case() {
  const auto make = [] { return into_hollow_edge(voxel_size); };
  const EdgeScene edge = make();
  const double depth = 2 * mm, scale = contact.stiffness * 3 * mm;
  const Vector3d caught = closed_form::held(contact, {-3 * mm, 0, -depth});
  const double t = time_of(edge, edge.arrivals[1], edge.arrivals[2],
                           [=](double speed) { return closed_form::leaves_hollow_edge(contact, depth, speed); });
  const double lag = closed_form::drag(contact, depth) / contact.stiffness;
  return {
      .id = "X05",
      .title = "A finger is caught in a hollow edge and drawn out of it",
      .truth_level = "L2",
      .statement = "2 mm deep in the floor it is led 3 mm into the wall of a hollow right-angled edge, then 6 mm out.",
      .formula = "caught: f = k (p - C) with C in the edge; breaks away at x = mu_s d - c V/k; then C = x - mu_d d",
      .note = "As X01. Its second breakaway is the one from the edge.",
      .runs = {run_of("in and out", make,
                      {force("f_x in the edge", Vector3d::UnitX(), rest_after(edge, 1), caught.x(), scale),
                       force("f_z in the edge", Vector3d::UnitZ(), rest_after(edge, 1), caught.z(), scale),
                       way_at("way of the finger when it breaks away", EventKind::breakaway, 2, Vector3d::UnitX(),
                              (edge.path(t) - edge.path(0)).x(), edge.velocity(t).x(), "L2: x = mu_s d - c V/k"),
                       friction("f_x at the end", Vector3d::UnitX(), rest_after(edge, 2), contact.stiffness * lag,
                                scale, 9 * mm, 1),
                       force("f_z at the end", Vector3d::UnitZ(), rest_after(edge, 2), caught.z(), scale)})}};
}

Case groove_case() {
  const auto make = [] { return along_groove(voxel_size); };
  const double drag = closed_form::groove_drag(contact, 2 * mm, 2 * mm), t = rest_after(make(), 2);
  const double press = -contact.stiffness * 2 * mm;
  return {.id = "X06",
          .title = "A finger drawn along a groove",
          .truth_level = "L2",
          .statement = "Held in a hollow right-angled edge, 2 mm deep in both faces, it is drawn 10 mm along it.",
          .formula = "f = mu_d k sqrt(d1^2 + d2^2): the limit of a fillet whose radius vanishes",
          .note = "As X01. Two Coulomb faces would give mu_d k (d1 + d2): chosen, see docs/contact-law.md.",
          .runs = {run_of(
              "drawn", make,
              {friction("force along the groove", Vector3d::UnitY(), t, drag, drag, 10 * mm, 1),
               force("f_x", Vector3d::UnitX(), t, press, drag), force("f_z", Vector3d::UnitZ(), t, press, drag)})}};
}

Case hollow_corner_case() {
  const auto make = [] { return into_hollow_corner(voxel_size); };
  const EdgeScene edge = make();
  const Vector3d caught = closed_form::held(contact, {-2 * mm, -3 * mm, -2 * mm});
  const double drag = closed_form::groove_drag(contact, 2 * mm, 3 * mm), scale = caught.norm();
  return {
      .id = "X07",
      .title = "A finger is caught in a hollow corner and leaves along its edge",
      .truth_level = "L2",
      .statement = "It is led to (-2, -3, -2) mm in a corner of three faces, then out along z to 5 mm.",
      .formula = "caught: f = k p; then f_z = mu_d k sqrt(x^2 + y^2)",
      .note = "As X01.",
      .runs = {run_of("in and out", make,
                      {force("f_x in the corner", Vector3d::UnitX(), rest_after(edge, 1), caught.x(), scale),
                       force("f_y in the corner", Vector3d::UnitY(), rest_after(edge, 1), caught.y(), scale),
                       force("f_z in the corner", Vector3d::UnitZ(), rest_after(edge, 1), caught.z(), scale),
                       friction("f_z on the way out", Vector3d::UnitZ(), rest_after(edge, 2), drag, scale, 7 * mm, 1),
                       force("f_y on the way out", Vector3d::UnitY(), rest_after(edge, 2), caught.y(), scale)})}};
}

Case groove_end_case() {
  const double depth = 2 * mm, half = 30 * mm, from = 25 * mm;
  const auto make = [=] {
    return edge_scene(
        "over the end of a groove", hollow_edge(), voxel_size, contact, {3 * mm, from, 1 * mm},
        {{0.3, {3 * mm, from, -depth}}, {0.5, {-depth, from, -depth}}, {1, {-depth, half + 5 * mm, -depth}}});
  };
  const EdgeScene edge = make();
  const double lag = closed_form::groove_drag(contact, depth, depth) / contact.stiffness;
  double early = edge.arrivals[1], late = edge.arrivals[2];
  for (int i = 0; i < 100; ++i) {
    const double t = 0.5 * (early + late);
    (edge.path(t).y() < half + lag ? early : late) = t;
  }
  return {.id = "X09",
          .title = "A finger drawn over the end of a groove",
          .truth_level = "L2",
          .statement = "As X06, but over the end of the hollow edge, where it meets the end face in a saddle corner.",
          .formula = "let go at mu_d sqrt(d1^2 + d2^2) beyond the end face, as over a convex edge",
          .note = "As X01. T is neither convex nor a union of two half spaces there.",
          .runs = {run_of("over the end", make,
                          {way_at("way of the finger when it is let go", EventKind::release, 1, Vector3d::UnitY(),
                                  half + lag - from, edge.velocity(early).y(), "L2: lag mu_d sqrt(d1^2 + d2^2)"),
                           count(EventKind::release, "releases", 1)})}};
}

Case kept_sheet_case() {
  const auto make = [] { return released_in_plate(voxel_size); };
  const double f = -contact.stiffness * 2.2 * mm;
  return {.id = "X08",
          .title = "A damper that lets go inside a plate keeps its sheet",
          .truth_level = "L2",
          .statement = "3.2 mm deep in a plate of 4 mm it is drawn back by 1 mm so fast that its damper lets go.",
          .formula = "it touches again on its own side: f = -k 2.2 mm, though the other side is 1.8 mm away",
          .note = "k = 100 N/m, c = 10 N s/m, one sample, no gravity, the body fixed.",
          .runs = {run_of("drawn back", make,
                          {force("force at the end", Vector3d::UnitZ(), rest_after(make(), 1), f, -f),
                           count(EventKind::release, "releases", 1), count(EventKind::touch, "touches", 2)})}};
}

}  // namespace

std::vector<Case> edge_cases() {
  return {leaves_convex_edge_case(), pressed_beside_edge_case(),
          held_beyond_edge_case(),   back_in_case(),
          hollow_edge_case(),        groove_case(),
          hollow_corner_case(),      kept_sheet_case(),
          groove_end_case()};
}

}  // namespace handhold::catalogue
