// SPDX-License-Identifier: GPL-3.0-or-later
// The reference against an independent solver, on every certification scene (catalogue/scenes/certification_scenes).
//
// Independent in full where faces are flat: they are analytic planes here and a spline of voxels there. On the ball
// both work on the same numbers in the voxels, each through its own spline code; how far the voxels are from the exact
// sphere is measured besides. What is shared is data: the scene and HandMotion's poses and velocities.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/certification_scenes.hpp"
#include "cases/closed_form/pulled_grip.hpp"
#include "cases/input/recording/recording_csv.hpp"
#include "reference/reference.hpp"
#include "tests/reference/independent/agreement.hpp"

namespace handhold::independent {
namespace {

using catalogue::CertificationScene;

SurfaceChoice surface_of(const CertificationScene& c, const Scene& scene) {
  const VoxelField& field = *scene.bodies.front().field;
  if (c.flat) return nearest_face(field);
  return [spline = std::make_shared<VoxelSpline>(field)](const Vec3&) { return spline; };
}

/// Refined: order 14 in place of 10, a tenth of the error a step.
Settings refined() {
  Settings settings;
  settings.columns = 7;
  settings.tolerance /= 10;
  return settings;
}

/// What a preset of the reference promises.
struct Bounds {
  const char* preset;
  double position, rotation, event_time;  // [m], [rad], [s]
};
constexpr Bounds all_bounds[] = {{"reference", 1e-7, 1e-6, 1e-6}, {"gold", 4e-10, 1e-8, 1e-8}};

std::vector<std::string> names(bool costly) {
  std::vector<std::string> out;
  for (const CertificationScene& c : catalogue::certification_scenes())
    if (c.costly == costly) out.push_back(c.name);
  return out;
}

std::string test_name(const ::testing::TestParamInfo<std::string>& info) {
  std::string out = info.param;
  for (char& c : out)
    if (c == '-') c = '_';
  return out;
}

/// With HANDHOLD_INDEPENDENT_OUT=FOLDER in the environment the answers are kept, for `handhold converge --independent`.
void keep(const std::string& name, double duration, const Result& truth) {
  const char* folder = std::getenv("HANDHOLD_INDEPENDENT_OUT");
  if (folder == nullptr) return;
  Recording recording;
  recording.engine = "independent";
  recording.scene = name;
  recording.body_names = {"body"};
  Frame frame;
  frame.t = duration;
  frame.bodies.resize(1);
  frame.bodies[0].X_WO = {truth.R_WO.cast<double>(), truth.p_WO.cast<double>()};
  recording.frames = {frame};
  for (const Happening& h : truth.events) recording.events.push_back({double(h.t), 0, h.kind, h.id, BodyState()});
  write_recording(recording, std::filesystem::path(folder) / name);
}

class Certified : public ::testing::TestWithParam<std::string> {};

TEST_P(Certified, AgreesWithTheIndependentSolver) {
  const CertificationScene& c = catalogue::certification_scene(GetParam());
  const Scene scene = c.scene();
  const SurfaceChoice surface = surface_of(c, scene);
  const Result truth = solve(scene, surface);
  keep(c.name, scene.duration, truth);
  // Truth must err less than a thousandth of the tightest bound: its poses are doubles (1e-16), its steps 1e-14.
  const Agreement own = agreement(truth, solve(scene, surface, refined()));
  std::cout << "  self       " << text(own, truth.events.size()) << "\n";
  EXPECT_EQ(own.events_differ, "");
  EXPECT_LE(own.position, 4e-13);
  EXPECT_LE(own.rotation, 1e-11);
  EXPECT_LE(own.event_time, 1e-11);
  EXPECT_EQ(truth.events.empty(), c.eventless);
  for (const Bounds& bounds : all_bounds) {
    const Recording recording = reference::simulate(scene, reference::preset(bounds.preset));
    ASSERT_EQ(recording.outcome, Outcome::complete) << recording.note;
    const Agreement a = agreement(truth, recording);
    std::cout << "  " << bounds.preset << (bounds.preset[0] == 'g' ? "       " : "  ")
              << text(a, recording.events.size()) << "\n";
    EXPECT_LE(a.position, bounds.position) << bounds.preset;
    EXPECT_LE(a.rotation, bounds.rotation) << bounds.preset;
    EXPECT_LE(a.event_time, bounds.event_time) << bounds.preset;
    EXPECT_EQ(a.events_differ, "") << bounds.preset;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Certified, ::testing::ValuesIn(names(false)), test_name);

// Numbers of the closed forms by 40-digit arithmetic (the project's Simbody study); the solver reaches them but for the
// poses' doubles and what cubic splines of 2 kHz miss of the breathing, (w / 2000)^4 / 384 of 4 mm = 3e-15 m.
TEST(IndependentSolver, IsTheClosedForm) {
  const closed_form::PulledGrip pulled;
  EXPECT_NEAR(breakaway_time(pulled), 0.0178303907510840, 1e-15);
  EXPECT_NEAR(restick_time(pulled), 0.0469374727453724, 1e-15);
  EXPECT_NEAR(object_position(pulled, 0.2), 0.0878394532810100, 1e-15);
  const Scene pull = catalogue::certification_scene("pull").scene();
  const Result a = solve(pull, nearest_face(*pull.bodies.front().field));
  ASSERT_EQ(a.events.size(), 4U);
  EXPECT_NEAR(double(a.events[0].t), breakaway_time(pulled), 1e-14);
  EXPECT_NEAR(double(a.events[3].t), restick_time(pulled), 1e-14);
  EXPECT_NEAR(double(a.p_WO.x()), object_position(pulled, 0.2), 1e-14);
  const closed_form::BreathingGrip breathing;
  EXPECT_NEAR(slip_onset(breathing), 0.2571129287486275, 1e-15);
  EXPECT_NEAR(height(breathing, 0.6), -0.2358463614091675, 1e-15);
  const Scene pinch = catalogue::certification_scene("pinch-open").scene();
  const Result b = solve(pinch, nearest_face(*pinch.bodies.front().field));
  ASSERT_EQ(b.events.size(), 2U);
  EXPECT_NEAR(double(b.events[0].t), slip_onset(breathing), 1e-12);  // 3e-15 m over a depth rate of 0.03 m/s
  EXPECT_NEAR(double(b.p_WO.z()), height(breathing, 0.6), 1e-12);
}

// The bounds guard something: an integration that is too loose for them breaks them, and another coefficient of
// friction by a millionth too.
TEST(Certification, SeesALooseAccuracyAndAWrongCoefficient) {
  const Bounds& bounds = all_bounds[0];
  const CertificationScene& c = catalogue::certification_scene("tilt");
  Scene scene = c.scene();
  const Result truth = solve(scene, surface_of(c, scene));
  reference::Options loose;
  loose.accuracy = 1e-5;
  EXPECT_GT(agreement(truth, reference::simulate(scene, loose)).position, bounds.position);
  scene.bodies.front().friction.mu_dynamic *= 1 + 1e-6;
  EXPECT_GT(agreement(truth, reference::simulate(scene, reference::preset("gold"))).position, bounds.position);
}

// The spline through the distances of a sphere of radius R errs by about h^4 / (384 R^3) = 1e-10 m at 1 mm, and its
// normals by 1e-6 rad; floats add 2^-25 of the distance, 1e-10 m. The ball's centre follows the surface; its rotation,
// weakly held, magnifies what normals err.
TEST(Certification, SaysHowFarTheVoxelsAreFromTheExactSphere) {
  const CertificationScene& c = catalogue::certification_scene("ball");
  const Scene scene = c.scene();
  const auto sphere = std::make_shared<Ball>(0.03L);
  const Result exact = solve(scene, [&](const Vec3&) { return sphere; });
  const Agreement a = agreement(exact, solve(scene, surface_of(c, scene)));
  std::cout << "  voxels of 1 mm from the exact sphere: " << text(a, exact.events.size()) << "\n";
  EXPECT_EQ(a.events_differ, "");
  EXPECT_LE(a.position, 1e-8);
  EXPECT_LE(a.rotation, 1e-5);
}

}  // namespace
}  // namespace handhold::independent
