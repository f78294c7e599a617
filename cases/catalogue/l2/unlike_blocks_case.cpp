// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/builders/slider_claims.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr int samples = 8, upper = 0, lower = 1;
constexpr Friction upper_friction{0.8, 0.6}, lower_friction{0.2, 0.15};  // together 0.4 and 0.3
const Eigen::Vector3d along = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitZ();

/// Pulled with r t from the speed r/K on, the spring loads evenly: q = r t/K.
closed_form::SliderOscillator pulled() {
  closed_form::SliderOscillator o{.mass = 0.2, .stiffness = 4000};
  o.friction = {std::sqrt(upper_friction.mu_static * lower_friction.mu_static),
                std::sqrt(upper_friction.mu_dynamic * lower_friction.mu_dynamic)};
  o.normal_force.constant = o.mass * 9.81;
  o.force.rate = 4;
  o.v = o.force.rate / o.stiffness;
  return o;
}

/// `owner` brings the samples that touch the other block.
Scene scene(const closed_form::SliderOscillator& o, int owner, double duration) {
  Scene scene;
  scene.name = "H01 two blocks";
  scene.duration = duration;
  scene.body_contact = {.stiffness = o.stiffness / samples, .damping = 0};
  Body top = block({edge, edge, edge}, 2 * voxel, o.mass, upper_friction);
  Body ground = block({4 * edge, 4 * edge, 2 * edge}, 4 * voxel, 1, lower_friction);
  top.name = "upper";
  top.mobility = Mobility::translation;
  top.X_WO.p = (edge / 2 - o.normal_force.constant / o.stiffness) * up;
  top.V_WO.v = o.v * along;
  top.load = [rate = o.force.rate](double t) -> Load { return {.force_W = rate * t * along}; };
  ground.name = "lower";
  ground.mobility = Mobility::fixed;
  ground.X_WO.p = -edge * up;
  Body& touching = owner == upper ? top : ground;
  touching.samples_O = ring((owner == upper ? -edge / 2 : edge) * up, up, along, 0.01, samples);
  scene.bodies = {top, ground};
  return scene;
}

Run run(const std::string& name, int owner) {
  const auto o = pulled();
  const double end = 27.0 / 90;
  const SliderClaims expect(o, end, along, samples);
  Run run{.name = name, .problem = [=] { return scene(o, owner, end); }};
  Claim onset = expect.breakaway(1, "onset");
  onset.measure.body = 1 - owner;  // what the samples touch
  onset.measure.owner = owner;
  run.claims = {onset, expect.slip(end, "slip at t = 0.3 s"), expect.speed(end, "speed at t = 0.3 s")};
  run.curve = expect.curve("slip [m]");
  return run;
}

}  // namespace

Case unlike_blocks_case() {
  return {.id = "H01",
          .title = "Two blocks with unlike friction",
          .truth_level = "L2",
          .statement =
              "A 0.2 kg block (mu_s = 0.8, mu_d = 0.6) on a fixed one (0.2, 0.15) is pulled with 4 N/s t; the upper or "
              "the lower one brings the samples that touch.",
          .formula = "mu of the pair is the geometric mean, 0.4 and 0.3; onset mu_s m g/r, then m x'' = r t - mu_d m g",
          .note =
              "K = 4000 N/m (8 samples), undamped. The block starts with r/K, so that the spring loads evenly and the "
              "onset is that of L1; at breakaway the lag drops to mu_d N/K.",
          .runs = {run("the upper one brings the samples", upper), run("the lower one brings the samples", lower)}};
}

}  // namespace handhold::catalogue
