// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/catalogue/l2/normal_shake_scene.hpp"

namespace handhold::catalogue {
namespace {

constexpr int index_finger = 5, thumb = 2;
const Eigen::Vector3d normal = Eigen::Vector3d::UnitY();

/// The implicit step answers the hand late by w h W²/(W² − w²) of phase, and rings by as much from the start.
Limit late_limit(const closed_form::ShakenPinch& p, double size) {
  const double square = 2 * p.stiffness / p.mass;
  const double late = p.frequency * square / (square - p.frequency * p.frequency);
  return {.per_step = 2.04 * size * late,
          .reason =
              "the implicit step answers late by w h W^2/(W^2 - w^2) of phase and rings from the start by as much, + "
              "2 %"};
}

Run steady_run() {
  // A quarter of a period is four frames.
  const closed_form::ShakenPinch p{.frequency = std::numbers::pi / 2 * 90 / 4};
  const double end = 33.0 / 90, peak = 4.0 / 90;
  const double Z = relative_amplitude(p), swing = p.stiffness * Z;
  Run run{.name = "A = 4 mm", .problem = [=] { return normal_shake_scene(p, {1, 1}, 0, end); }};
  const auto z_at = [&](double t, const std::string& quantity) {
    return claim(quantity, relative_displacement(p, t), "L2: z = Z sin w t, Z = A w^2/(2 K/m - w^2)",
                 displacement_at(t, normal), controlled_limit(10, "z is a tenth of the motion of hand and object"),
                 late_limit(p, Z));
  };
  const auto force_at = [&](int finger, double truth, const std::string& quantity) {
    const Eigen::Vector3d push = finger == thumb ? normal : Eigen::Vector3d(-normal);
    return claim(quantity, truth, "L2: K (d0 -+ z)",
                 {.kind = Measure::Kind::force, .axis = push, .at = peak, .phalanx = finger},
                 controlled_limit(10, "z is a tenth of the motion of hand and object"), late_limit(p, swing));
  };
  run.claims = {z_at(peak, "Z, at t = 4/90 s"), z_at(end, "z at t = 33/90 s"),
                force_at(thumb, p.stiffness * (p.preload - Z), "least normal force"),
                force_at(index_finger, p.stiffness * (p.preload + Z), "greatest normal force")};
  run.curve = Curve{"object - hand [m]", {.kind = Measure::Kind::displacement, .axis = normal}, [p](double t) {
                      return relative_displacement(p, t);
                    }};
  return run;
}

/// Slow enough that a hand between the frames it is known on, off by 0.05 (ω dt)³ A, is known to 0.5 % of Z.
closed_form::ShakenPinch slow(double amplitude_share) {
  closed_form::ShakenPinch p{.preload = 0.001, .frequency = 8};
  p.amplitude = amplitude_share * critical_amplitude(p);
  return p;
}

Run contact_run(double share) {
  const closed_form::ShakenPinch p = slow(share);
  const double end = 0.9;
  return near_threshold(
      share,
      [=] {
        return normal_shake_scene(p, {1, 1}, 0, end);
      },
      yes_or_no("keeps touch", share < 1, "L2: iff Z <= d0, A <= d0 |2 K/m - w^2|/w^2", none_of(EventKind::release)));
}

}  // namespace

Case normal_shake_case() {
  return {
      .id = "G11",
      .title = "Pinch shaken along the normals: relative motion and normal forces",
      .truth_level = "L2",
      .statement = "Two fingers hold a 0.2 kg cube, 3 mm deep each, and move as 4 mm sin(35.3 t) along their normals.",
      .formula = "z = Z sin w t, Z = A w^2/(2 K/m - w^2); N = K (d0 -+ z), their sum 2 K d0; touch is kept iff Z <= d0",
      .note =
          "K = 800 N/m a finger, undamped, started in the forced oscillation, rotation locked; w so that extremes "
          "fall on frames. Threshold runs: d0 = 1 mm, w = 8 rad/s. L1: no relative motion.",
      .runs = {steady_run(), contact_run(0.98), contact_run(1.02)}};
}

}  // namespace handhold::catalogue
