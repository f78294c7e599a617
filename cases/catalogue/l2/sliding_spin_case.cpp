// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/planar_scenes.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

using closed_form::PlanarSlide;
using closed_form::PlanarState;
using Eigen::Vector2d;

constexpr double stiffness = 500, mu = 0.3, radius = 0.02, mass = 0.2;
const Eigen::Vector3d along = Eigen::Vector3d::UnitX(), axis = Eigen::Vector3d::UnitY();
const Eigen::Vector3d sideways = Eigen::Vector3d::UnitZ();

/// Two rings carry m g/2 each; all samples start with their leash along the hand's motion over the object.
PlanarSlide sliding() {
  PlanarSlide s{.mass = mass, .inertia = 0.5 * mass * radius * radius, .velocity = {0, 0.5}, .spin = 20};
  const double normal_force = mass * 9.81 / 2 / 8;
  for (int i = 0; i < 8; ++i) {
    const double at = 2 * std::numbers::pi * i / 8;
    const Vector2d p = radius * Vector2d{std::cos(at), std::sin(at)};
    const Vector2d hand = -(s.velocity + s.spin * Vector2d{-p.y(), p.x()});
    s.slipping.push_back({p, 2 * mu * normal_force, mu * normal_force / stiffness, std::atan2(hand.y(), hand.x())});
  }
  return s;
}

struct Change {
  double speed{}, acceleration{};  ///< of what is measured, from 0 to t
};

/// Positions: half a sub-step times the gained speed (R03), and as much of the gained acceleration over the time, since
/// forces are taken at the ends of steps.
Limit stepped_limit(const Change& change, double t) {
  return {.per_step = std::abs(change.speed) + std::abs(change.acceleration) * t,
          .reason =
              "twice (for what errors feed back into the directions of friction): half a sub-step times the gained "
              "speed (R03), "
              "+ half a sub-step times the gained acceleration, over t"};
}

Change change_of(const PlanarSlide& s, double t, double (*read)(const PlanarState&)) {
  const double e = 1e-6;
  const double now = read(planar_state(s, t)), start = read(planar_state(s, 0));
  const double late = (now - read(planar_state(s, t - e))) / e, early = (read(planar_state(s, e)) - start) / e;
  return {now - start, late - early};
}

const std::string source = "L2: motion of body and leashes by GSL; 1e-11 against 1e-13 a step agrees to 1e-12";

}  // namespace

Case sliding_spin_case() {
  const PlanarSlide s = sliding();
  const PlanarLayout layout{.size = {4 * edge, edge / 2, 4 * edge},
                            .voxel_size = 2 * voxel,
                            .stiffness = stiffness,
                            .friction = {.mu_static = mu, .mu_dynamic = mu}};
  const PlanarState stop = first_restick(s, 0.4);
  const double mid = 9.0 / 90, late = 16.0 / 90;
  Run run{.name = "slides and spins", .problem = [=] { return planar_scene("F04 sliding spin", s, layout, 0.2); }};
  const auto place = [](const PlanarState& p) { return p.velocity.y(); };
  const auto drift = [](const PlanarState& p) { return p.velocity.x(); };
  const auto turn = [](const PlanarState& p) { return p.spin; };
  for (const double t : {mid, late}) {
    const PlanarState now = planar_state(s, t);
    const std::string when = t == mid ? " at t = 0.1 s" : " at t = 8/45 s";
    run.claims.push_back(
        of_pedigree(Pedigree::converged,
                    claim("place" + when, now.center.y(), source, displacement_at(t, along), controlled_limit(),
                          stepped_limit(change_of(s, t, place), t), /*converges=*/t == mid)));
    run.claims.push_back(
        of_pedigree(Pedigree::converged,
                    claim("drift aside" + when, now.center.x(), source, displacement_at(t, sideways),
                          controlled_limit(10, "a twentieth of the way"), stepped_limit(change_of(s, t, drift), t))));
    // Of first order too, but lead and lag nearly cancel: its order would show that of the second.
    run.claims.push_back(
        of_pedigree(Pedigree::converged, claim("angle" + when, now.angle, source, rotation_at(t, axis),
                                               controlled_limit(), stepped_limit(change_of(s, t, turn), t))));
  }
  run.claims.push_back(
      of_pedigree(Pedigree::converged,
                  claim("first sample sticks", stop.t, source, time_of(EventKind::restick), absolute_controlled_limit(),
                        event_limit(2, "speeds are off by up to a sub-step of acceleration"))));
  run.curve = Curve{"place [m]", {.kind = Measure::Kind::displacement, .axis = along}, [=](double t) {
                      return t < stop.t ? planar_state(s, t).center.y() : std::nan("");
                    }};
  return {
      .id = "F04",
      .title = "Coupled sliding and spinning between two rings",
      .truth_level = "L2",
      .statement =
          "A 0.2 kg plate between two rings of 20 mm radius, m g/2 each, slides with 0.5 m/s and spins with 20 rad/s; "
          "mu = 0.3, no gravity.",
      .formula = "m v' = sum f_i, I w' = sum r_i x f_i, f_i = mu N u_i, u_i' = -(v_i - (v_i u_i) u_i)/rho",
      .note =
          "k = 500 N/m a sample, undamped. The rings belong to the hand here, not to the plate as in the catalogue, so "
          "the plate's centre leaves them and its closed terminal ratio does not apply; truth is the equation of "
          "motion of the 8 places, integrated by a program of its own.",
      .runs = {run}};
}

}  // namespace handhold::catalogue
