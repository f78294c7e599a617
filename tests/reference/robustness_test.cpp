// SPDX-License-Identifier: GPL-3.0-or-later
// Odd scenes and wrong ones. (Starting outside the cone, touching while sliding, no friction, no gravity: palm_test.)

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"
#include "tests/reference/scenes.hpp"

namespace handhold::reference {
namespace {

using Eigen::Vector3d;
using namespace testing;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A damped block swings itself out and then rests: in stick nothing creeps, not by a bit, for an anchor does not move.
TEST(Robustness, ABlockRestsForAMinute) {
  Scene scene = palm_scene(60);
  scene.contact.damping = 4;
  scene.gravity = {0.05 * gravity, 0, -gravity};  // well inside the cone, and it does not tip
  Options options;
  options.max_step = 0.01;
  options.frame_rate = 10;
  const Recording r = simulate(scene, options);
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  for (const Event& event : r.events) EXPECT_LT(event.t, 1);     // the sudden load at the start
  const Frame &settled = r.frames[200], &end = r.frames.back();  // at 20 s
  const auto anchor_O = [](const Frame& f, std::size_t i) {
    return Vector3d(f.bodies[0].X_WO.inverse() * f.contacts[i].C_W);
  };
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT((anchor_O(end, i) - anchor_O(settled, i)).norm(), 1e-16);        // round-off of C_W
  EXPECT_LT((end.bodies[0].X_WO.p - settled.bodies[0].X_WO.p).norm(), 1e-13);  // what the integrator's steps leave
}

// mu_s = mu_d: breaking away changes no force, sticking again neither; there must be no chatter.
TEST(Robustness, EqualCoefficientsDoNotChatter) {
  for (const double damping : {0.0, 1.0}) {
    Scene scene = palm_scene(0.5);
    scene.contact.damping = damping;
    scene.bodies[0].friction = {0.4, 0.4};
    scene.bodies[0].mobility = Mobility::translation;
    scene.bodies[0].load = [](double t) { return Load{{1.2 * std::sin(40 * t), 0, 0}, {0, 0, 0}}; };  // slips at 0.78 N
    const Recording r = simulate(scene, {});
    ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
    EXPECT_GE(r.events.size(), 8u);
    EXPECT_LE(r.events.size(), 200u);  // the springs ring at 14 Hz in the stick phases: a few a period
    EXPECT_LT(energy_residual(r), 1e-8);
  }
}

// Two samples whose cones are left at the same instant: both break away then.
TEST(Robustness, TwoContactsBreakAwayAtOnce) {
  Scene scene = palm_scene(0.05);
  scene.bodies[0].mobility = Mobility::translation;
  scene.bodies[0].V_WO.v = {0.3, 0, 0};
  const Recording r = simulate(scene, {});
  ASSERT_EQ(r.outcome, Outcome::complete) << r.note;
  ASSERT_EQ(r.events.size(), 4u);
  for (const Event& event : r.events) {
    EXPECT_EQ(event.kind, EventKind::breakaway);
    EXPECT_NEAR(event.t, r.events[0].t, 1e-9);
  }
}

// A load that is not finite from some time on is found on the way, and says so.
TEST(Robustness, NamesALoadThatBreaksDown) {
  Scene scene = cube_scene(0.2);
  scene.bodies[0].load = [](double t) { return Load{{t < 0.1 ? 0.0 : nan, 0, 0}, {0, 0, 0}}; };
  try {
    (void)simulate(scene, {});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("body 'cube': its load at t = 0.1"), std::string::npos) << error.what();
  }
}

// An undamped sample dragged round an edge sharper than its depth has no solution on the rounded spline: the note says
// which contact, on which body, and when; what was recorded until then stays.
TEST(Robustness, SaysWhatCannotAdvance) {
  Scene scene = cube_scene(0.5);
  scene.bodies[0].mobility = Mobility::fixed;
  Patch patch;
  patch.phalanx = 5;
  patch.points = {{0, 0, 0}};
  patch.pose = [](double t) { return Pose{Eigen::Quaterniond::Identity(), {0.02 + 0.05 * t, 0, half_edge - 0.004}}; };
  scene.hands.push_back(hand_with({patch}, 0.6));
  Options rounded;
  rounded.surface = SurfaceModel::voxels;
  const Recording r = simulate(scene, rounded);
  ASSERT_EQ(r.outcome, Outcome::stalled);
  for (const char* word : {"index_distal", "sample 0", "body 'cube'", "t = 0."})
    EXPECT_NE(r.note.find(word), std::string::npos) << r.note;
  EXPECT_GT(r.frames.size(), 10u);
}

void expect_refused(const Scene& scene, const Options& options = {}) {
  EXPECT_THROW((void)simulate(scene, options), InputError);
}

// Simbody would abort on some of these, and simulate nonsense with others (see also tests/fuzz).
TEST(Robustness, RefusesWrongScenes) {
  const Scene good = palm_scene(0.1);
  const auto with = [&](const auto& change) {
    Scene scene = good;
    change(scene, scene.bodies[0]);
    expect_refused(scene);
  };
  with([](Scene&, Body& b) { b.inertia.mass = -1; });
  with([](Scene&, Body& b) { b.inertia.mass = nan; });
  with([](Scene&, Body& b) { b.inertia.about_center.setZero(); });
  with([](Scene&, Body& b) { b.X_WO.p.y() = nan; });
  with([](Scene&, Body& b) { b.X_WO.R.w() = nan; });
  with([](Scene&, Body& b) { b.X_WO.R.coeffs().setZero(); });
  with([](Scene&, Body& b) { b.V_WO.w.x() = nan; });
  with([](Scene&, Body& b) { b.field = nullptr; });
  with([](Scene&, Body& b) { b.samples_O = {{0, 0, nan}}; });
  with([](Scene&, Body& b) { b.load = [](double) { return Load{{0, 0, 0}, {0, nan, 0}}; }; });
  with([](Scene& s, Body&) { s.duration = -1; });
  with([](Scene& s, Body&) { s.gravity.x() = nan; });
  with([](Scene& s, Body&) { s.body_contact.stiffness = -1; });
  with([](Scene& s, Body&) { s.hands[0].motion = nullptr; });
  with([](Scene& s, Body&) { s.hands[0].given[0].phalanx = 16; });
  with([](Scene& s, Body&) { s.bodies.clear(); });
  Options fast;
  fast.frame_rate = 1e9;  // a hundred million frames
  expect_refused(good, fast);
}

TEST(Robustness, RefusesMoreSamplesThanItCanHold) {
  Scene scene = cube_scene(0.1);
  scene.bodies[0].samples_O.assign(255, Vector3d::Zero());
  while (scene.bodies.size() < 21) {
    scene.bodies.push_back(scene.bodies[0]);
    scene.bodies.back().name = std::to_string(scene.bodies.size());
  }
  expect_refused(scene);
}

}  // namespace
}  // namespace handhold::reference
