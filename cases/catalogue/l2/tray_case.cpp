// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/claims.hpp"
#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/families.hpp"
#include "cases/closed_form/tray.hpp"

namespace handhold::catalogue {
namespace {

constexpr double damping = 20;  // [N s/m] per sample: modes of frequency w fade as exp(-w^2 t/200)

Scene scene(const closed_form::Tray& t, double duration) {
  Scene scene;
  scene.name = "G07 tray";
  scene.duration = duration;
  scene.contact = {.stiffness = t.stiffness, .damping = damping};
  Body body = block({2 * edge, 1.5 * edge, 2 * t.height}, 2 * voxel, t.mass, {0.5, 0.5});
  body.inertia.center = {t.x, t.y, 0};
  body.X_WO.p.z() = t.height - t.mass * t.gravity / (4 * t.stiffness);
  scene.bodies = {body};
  const std::vector<Eigen::Vector3d> points{{t.a, t.b, 0}, {t.a, -t.b, 0}, {-t.a, t.b, 0}, {-t.a, -t.b, 0}};
  const Path still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  scene.hands = {hand_of({{palm, points, std::vector<SampleStart>(4), still}}, duration)};
  return scene;
}

}  // namespace

Case tray_case() {
  const closed_form::Tray tray;
  const double end = 54.0 / 90;
  Run run{.name = "comes to rest", .problem = [=] { return scene(tray, end); }};
  const auto truth = vertical_forces(tray);
  const char* const names[] = {"force at (+a, +b)", "force at (+a, -b)", "force at (-a, +b)", "force at (-a, -b)"};
  for (int i = 0; i < 4; ++i)
    run.claims.push_back(claim(
        names[i], truth[std::size_t(i)],
        "L2: m g/4 - k (R c_i)_z, R the lean at which k sum (R c_i) x c_i = m g (R r) x z",
        {.kind = Measure::Kind::force, .axis = Eigen::Vector3d::UnitZ(), .at = end, .sample = i}, controlled_limit(),
        {.value = 1e-12,
         .relative = true,
         .reason = "rest does not depend on the step, and nothing of the settling is left: the solve, to "
                   "1e-13, and rounding"}));
  return {
      .id = "G07",
      .title = "How four springs share a tray",
      .truth_level = "L2",
      .statement =
          "A 0.4 kg tray, its centre of mass 10 mm and 5 mm off the middle, lies on four samples at (+-50, +-30) mm.",
      .formula =
          "N_i = m g (1/4 + x x_i/(4 a^2) + y y_i/(4 b^2)) for a level tray; L1: only bounds, 0.719 N to 2.289 N "
          "for the first",
      .note =
          "k = 2000 N/m, c = 20 N s/m. The tray leans by 4 mrad, which shifts forces by 0.2 %: truth is the exact "
          "balance of the leaning tray, not the level formula (1.3407, 1.0137, 0.9483, 0.6213 N).",
      .runs = {run}};
}

}  // namespace handhold::catalogue
