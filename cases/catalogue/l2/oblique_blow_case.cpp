// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"

namespace handhold::catalogue {
namespace {

constexpr double mass = 0.2, frequency = 20, gap = 0.0052, down = 0.2;  // [kg], [rad/s], [m], [m/s]
constexpr double stiffness = mass * frequency * frequency;              // of all samples [N/m]
constexpr double contact_time = std::numbers::pi / frequency;
constexpr Friction friction{.mu_static = 0.5, .mu_dynamic = 0.4};
const Eigen::Vector3d along = Eigen::Vector3d::UnitX(), up = Eigen::Vector3d::UnitZ();

Scene scene(double sideways, double duration) {
  Scene scene;
  scene.name = "H09 oblique blow";
  scene.duration = duration;
  scene.gravity.setZero();
  scene.contact = {.stiffness = stiffness / 8, .damping = 0};
  Body body = block(Eigen::Vector3d::Constant(4 * edge), 8 * voxel, mass, friction);
  body.mobility = Mobility::translation;
  body.X_WO.p = (2 * edge + gap) * up;
  body.V_WO.v = sideways * along - down * up;
  scene.bodies = {body};
  scene.hands = {
      hand_of({palm_patch({}, [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); })}, duration)};
  return scene;
}

/// What the implicit step's damping takes of a speed that is turned round by half a period, twice.
Limit blow_limit(double speed) {
  Limit limit = implicit_ring_limit(speed, frequency, contact_time);
  limit.per_step *= 2;
  limit.reason += ", twice that for what is of second order";
  return limit;
}

Run run(const std::string& name, double sideways, bool sticks) {
  const double end = 27.0 / 90;
  const double after = sticks ? -sideways : sideways - 2 * friction.mu_dynamic * down;
  Run run{.name = name, .problem = [=] { return scene(sideways, end); }};
  run.claims = {
      claim("touch", gap / down, "L1 = L2: gap/v", time_of(EventKind::touch),
            absolute_controlled_limit(1 + 1 / down, "of places, over the speed of the crossing"), event_limit()),
      claim("speed away", down, "L2: half a period of the spring", speed_at(end, up), controlled_limit(),
            blow_limit(down)),
      claim("speed sideways", after,
            sticks ? "L2: half a period of the same spring" : "L1 = L2: v - 2 mu_d v_n, slipping throughout",
            speed_at(end, along), controlled_limit(), blow_limit(sticks ? sideways : friction.mu_dynamic * down))};
  if (!sticks)  // where it sticks, load and cone vanish together at both ends of the contact: no number tells them
                // apart
    run.claims.push_back(yes_or_no("never sticks", true, "L2: the anchor goes on", none_of(EventKind::restick)));
  return run;
}

}  // namespace

Case oblique_blow_case() {
  return {
      .id = "H09",
      .title = "An oblique blow on the palm, between the cones",
      .truth_level = "L2",
      .statement =
          "A 0.2 kg block comes down on the palm with 0.2 m/s, and sideways with 0.09 or 0.24 m/s; mu_s = 0.5, mu_d "
          "= 0.4, no gravity.",
      .formula =
          "the element is the same spring in all directions: t*/N = v/v_n for the whole contact. 0.45 is below mu_s: "
          "it sticks, and all of its speed is turned round; 1.2 slips: v - 2 mu_d v_n",
      .note = "K = 80 N/m (8 samples), undamped, rotation locked.",
      .runs = {run("sticks", 0.45 * down, true), run("slips", 1.2 * down, false)}};
}

}  // namespace handhold::catalogue
