// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/near_threshold.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/catalogue/l2/normal_shake_scene.hpp"
#include "cases/closed_form/ratchet.hpp"

namespace handhold::catalogue {
namespace {

constexpr int half_frames = 47;     // of half a period
constexpr double step = 1.0 / 360;  // sub-step at which the implicit step's damping is evaluated [s]
const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();

closed_form::Ratchet creeping(double damping) {
  closed_form::Ratchet r{.mu = 0.5, .damping = damping};
  r.pinch = {.stiffness = 800, .preload = 0.003, .amplitude = 1, .frequency = std::numbers::pi * 90 / half_frames};
  r.pinch.amplitude = 0.001 / relative_amplitude(r.pinch);
  return r;
}

Run creeping_run() {
  const closed_form::Ratchet r = creeping(0);
  const double cycle = 2 * half_frames / 90.0, end = 2 * cycle;
  const closed_form::RatchetMotion truth(r, 4), stepped(creeping(r.pinch.stiffness * step), 4);
  Run run{.name = "Z = 1 mm creeps", .problem = [=] {
            return normal_shake_scene(r.pinch, {r.mu, r.mu}, r.gravity, end);
          }};
  const std::string source = "L2: one slider oscillator each half period, by turns";
  // The hand is answered late by w h W²/(W² − w²) of phase, 1.005 h here.
  const auto shift = [](double a, double b) { return 2 * std::abs(a - b) / step; };
  const std::string analysis =
      "twice the shift that a damping of h K gives (backward error analysis of the implicit step), + the late answer "
      "of "
      "the normal springs";
  run.claims = {
      claim("first slip", truth.first_breakaway().t, source, time_of(EventKind::breakaway), absolute_controlled_limit(),
            {.per_step = 2.03 + shift(truth.first_breakaway().t, stepped.first_breakaway().t),
             .reason = "shows at the end of its sub-step, + " + analysis}),
      claim("first stop", truth.first_restick().t, source, time_of(EventKind::restick),
            absolute_controlled_limit(
                1 + std::sqrt(2 * r.pinch.stiffness / r.pinch.mass) / std::abs(truth.first_restick().rate),
                "a speed of the oscillation is known to w times its place; over the rate at which it vanishes"),
            {.per_step = 2.03 + shift(truth.first_restick().t, stepped.first_restick().t),
             .reason = "shows at the end of its sub-step, + " + analysis})};
  for (const double t : {cycle, end}) {
    const double creep = truth.creep(t);
    run.claims.push_back(
        claim(t < end ? "creep in the first cycle" : "creep in two cycles", creep, source, displacement_at(t, down),
              absolute_controlled_limit(),
              {.per_step = shift(creep, stepped.creep(t)) + 1.03 * r.pinch.frequency * creep, .reason = analysis}));
  }
  run.curve = Curve{
      "creep [m]", {.kind = Measure::Kind::displacement, .axis = down}, [truth](double t) { return truth.creep(t); }};
  return run;
}

/// As slow as case G11's, and for its reason.
Run threshold_run(double share) {
  closed_form::Ratchet r;
  r.pinch = {.stiffness = 800, .preload = 0.003, .amplitude = 1, .frequency = 8};
  r.pinch.amplitude = share * shakedown_amplitude(r) / relative_amplitude(r.pinch);
  return near_threshold(
      share,
      [=] {
        return normal_shake_scene(r.pinch, {r.mu, r.mu}, r.gravity, 0.9);
      },
      yes_or_no("shakes down", share < 1, "L2: iff mu K (d0 - Z) >= m g/2", none_of(EventKind::breakaway)));
}

}  // namespace

Case ratchet_case() {
  return {
      .id = "G06",
      .title = "Pinch shaken along the normals: creeps although 2 mu N0 > m g",
      .truth_level = "L2",
      .statement =
          "Two fingers hold a 0.2 kg cube, 3 mm deep each (2.4 N), mu = 0.5, and shake along their normals so that the "
          "depths change by 1 mm.",
      .formula =
          "L1: holds iff 2 mu K d0 >= m g. L2: shakes down iff mu K (d0 - Z) >= m g/2; else creeps, slowly "
          "shaken, 2 (m g - 2 mu K (d0 - Z))/K a cycle",
      .note =
          "K = 800 N/m a finger, undamped, rotation locked; truth counts the cube's inertia, at 6 rad/s: 0.72 mm in "
          "the first cycle, where slow shaking gives 0.905 mm each (Z = 1.5 mm, as in the catalogue, would let both "
          "fingers slip at once). Threshold runs: w = 8 rad/s.",
      .runs = {creeping_run(), threshold_run(0.98), threshold_run(1.02)}};
}

}  // namespace handhold::catalogue
