// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr double stiffness = 100;  // of every sample
constexpr int samples = 16;        // of hand 1; hand 2 has 12
constexpr double mass = 0.2, gravity = 9.81;
constexpr double first_force = 4, rate = 4, second_force = 5;  // [N], [N/s], [N] of each finger
constexpr double first_stiffness = samples * stiffness, second_stiffness = 12 * stiffness;
const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();

/// x counts down; hand 1 is the element, hand 2 the tether.
closed_form::SliderOscillator handover() {
  closed_form::SliderOscillator o{.mass = mass,
                                  .stiffness = first_stiffness,
                                  .friction = {.mu_static = 0.5, .mu_dynamic = 0.5},
                                  .tether = second_stiffness};
  o.normal_force = {.constant = 2 * first_force, .rate = -2 * rate};
  o.force.constant = mass * gravity;
  o.stretch = mass * gravity / first_stiffness;
  return o;
}

/// Hand 2: thumb and index along x, six samples each, slack.
Hand second_hand(double duration) {
  const double depth = second_force / (6 * stiffness);
  const Path still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  std::vector<MovingPatch> patches;
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d center = side * (edge / 2 - depth) * Eigen::Vector3d::UnitX();
    const auto points = ring(center, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), 0.004, 6);
    patches.push_back({side < 0 ? 2 : 5, points, std::vector<SampleStart>(points.size()), still});
  }
  return hand_of(patches, duration);
}

Scene scene(double duration) {
  Scene scene;
  scene.name = "G05 handover";
  scene.duration = duration;
  scene.contact = {.stiffness = stiffness, .damping = 0};
  Body body = block({edge, edge, edge}, 2 * voxel, mass, handover().friction);
  body.mobility = Mobility::translation;
  scene.bodies = {body};
  const Path still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  const double finger = first_stiffness / 2;
  const auto opens = [finger](double t) { return -rate / finger * t; };
  const SampleStart loaded{.lag_W = -mass * gravity / first_stiffness * down};
  scene.hands = {hand_of(pinch_patches(edge / 2, first_force / finger, loaded, opens, still), duration),
                 second_hand(duration)};
  return scene;
}

/// Once hand 1 is open the cube swings on the springs of hand 2.
double sag_after(const closed_form::SliderState& open, double tau) {
  const double mean = mass * gravity / second_stiffness, w = std::sqrt(second_stiffness / mass);
  return mean + (open.x - mean) * std::cos(w * tau) + open.v / w * std::sin(w * tau);
}

}  // namespace

Case handover_case() {
  const auto o = handover();
  const double open = first_force / rate, end = open + 9.0 / 90;
  const SliderClaims expect(o, open, down, samples);
  const closed_form::SliderState at_opening = expect.truth().at(open);
  Run run{.name = "hands over", .problem = [=] { return scene(end); }};
  run.claims = {expect.breakaway(1, "onset"), expect.slip(54.0 / 90, "sag at t = 0.6 s"),
                expect.slip(81.0 / 90, "sag at t = 0.9 s"), expect.slip(open, "sag when hand 1 opens, 1 s")};
  const double mean = mass * gravity / second_stiffness;
  const double swing = std::hypot(at_opening.x - mean, at_opening.v / std::sqrt(second_stiffness / mass));
  run.claims.push_back(
      claim("sag at t = 1.1 s", sag_after(at_opening, end - open), "L2: m g/K2 + the oscillation that is left",
            displacement_at(end, down), absolute_controlled_limit(),
            {.value = 2 * swing,
             .reason = "the implicit step damps the oscillation of 18 um out, before and after the opening"}));
  run.curve = Curve{"sag [m]", {.kind = Measure::Kind::displacement, .axis = down}, [=](double t) {
                      return t < open ? expect.truth().at(t).x : sag_after(at_opening, t - open);
                    }};
  return {.id = "G05",
          .title = "Handover in mid-air: the load moves by stiffness",
          .truth_level = "L2",
          .statement =
              "Hand 1 holds a 0.2 kg cube with 4 N a finger, hand 2 grips it with 5 N, slack; hand 1 opens with 4 N/s; "
              "mu = 0.5.",
          .formula =
              "t1 = (N0 - m g/(2 mu))/r; then x = (m g - F1)/K2 - 2 mu r/(K2 w2) sin(w2 tau), F1 = 2 mu (N0 - r t), "
              "w2 = sqrt(K2/m); at last about m g/K2",
          .note =
              "K1 = 1600 N/m, K2 = 1200 N/m (2 x 8 and 2 x 6 samples), undamped, rotation locked; voxels of 1 mm, so "
              "that 8.3 mm of depth lie within the band. L1: no sag, and how "
              "the hands share the load is undetermined.",
          .runs = {run}};
}

}  // namespace handhold::catalogue
