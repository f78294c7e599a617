// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be simulated is refused with a reason, or recorded as such; the same run gives the same bits.

#include <cmath>
#include <functional>
#include <limits>

#include "cases/model/input_error.hpp"
#include "tests/reference/rigid/problems.hpp"

namespace handhold::reference::rigid::testing {
namespace {

void expect_refusal(const std::function<void(RigidProblem&)>& spoil, const std::string& word) {
  RigidProblem p = block(0.2, {0.5, 0.4}, 0.1);
  spoil(p);
  try {
    (void)simulate(p);
    ADD_FAILURE() << "no refusal: " << word;
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find(word), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  }
}

TEST(RigidInput, IsRefusedWithAReason) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refusal([](RigidProblem& p) { p.mass = -1; }, "mass");
  expect_refusal([&](RigidProblem& p) { p.mass = nan; }, "mass");
  expect_refusal([](RigidProblem& p) { p.inertia = Eigen::Vector3d(1, 1, 3).asDiagonal(); }, "inertia");
  expect_refusal([&](RigidProblem& p) { p.inertia(0, 0) = nan; }, "inertia");
  expect_refusal([](RigidProblem& p) { p.mobility = Mobility::fixed; }, "mobility");
  expect_refusal([](RigidProblem& p) { p.X_WB.R.coeffs().setZero(); }, "quaternion");
  expect_refusal([](RigidProblem& p) { p.V_WB.w.x() = 1; }, "translating");
  expect_refusal([&](RigidProblem& p) { p.gravity.x() = nan; }, "gravity");
  expect_refusal([](RigidProblem& p) { p.duration = 0; }, "duration");
  expect_refusal([](RigidProblem& p) { p.supports.resize(6, p.supports[0]); }, "6 supports");
  expect_refusal([](RigidProblem& p) { p.supports[0].friction = {0.3, 0.4}; }, "mu");
  expect_refusal([](RigidProblem& p) { p.supports[0].surface.direction.setZero(); }, "direction");
  expect_refusal([](RigidProblem& p) { p.supports[0].surface = make_sphere({0, 0, 0}, 0); }, "radius 0");
  expect_refusal([](RigidProblem& p) { p.supports[0].radius = -1; }, "radius");
  expect_refusal([](RigidProblem& p) { p.X_WB.p.z() = -1e-3; }, "starts inside");
  expect_refusal(
      [](RigidProblem& p) {
        p.supports[0].surface = make_sphere({0, 0, 0}, 1, true);
        p.supports[0].radius = 2;
      },
      "wider");
  expect_refusal(
      [](RigidProblem& p) {
        p.supports[0].surface = make_sphere({0, 0, -1}, 1);
        p.supports[0].normal_force = [](double) { return 1.0; };
      },
      "only planes");
  expect_refusal(
      [](RigidProblem& p) {
        p.mobility = Mobility::free;
        p.supports[0].normal_force = [](double) { return 1.0; };
      },
      "rotates");
  expect_refusal(
      [](RigidProblem& p) {
        p.supports[0].motion = [](double t) { return PathPoint{{std::sin(t), 0, 0}, {0, 0, 0}, {0, 0, 0}}; };
      },
      "derivatives");
  expect_refusal(
      [](RigidProblem& p) {
        p.supports[0].turn = [](double t) {
          return TurnPoint{Eigen::Quaterniond(Eigen::AngleAxisd(t, z_axis)), 2 * z_axis, {0, 0, 0}};
        };
      },
      "rates of its turn");
  expect_refusal(
      [](RigidProblem& p) {
        p.supports[0].turn = [](double t) {
          return TurnPoint{Eigen::Quaterniond(Eigen::AngleAxisd(t * t, z_axis)), 2 * t * z_axis, {0, 0, 0}};
        };
      },
      "rates of its turn");
  expect_refusal(
      [](RigidProblem& p) {
        p.supports[0].turn = turning(z_axis, 1);
        p.supports[0].normal_force = constant(1);
      },
      "cannot turn");
  expect_refusal([](RigidProblem& p) { p.springs = {{-1, {0, 0, 0}, {0, 0, 0}, {}}}; }, "stiffness");
  expect_refusal(
      [&](RigidProblem& p) { p.load = [=](double, const BodyState&) {
                               return Load{{nan, 0, 0}, {0, 0, 0}};
                             }; },
      "load");
}

TEST(RigidInput, OptionsAreRefusedWithAReason) {
  for (const Options& o : {Options{0}, Options{1e-14}, Options{1e-10, 0}, Options{1e-10, 1e-3, -1},
                           Options{1e-10, 1e-3, 100, 0}, Options{1e-10, 1e-3, 1e12}})
    EXPECT_THROW((void)simulate(block(0.2, {0.5, 0.4}, 0.1), o), InputError);
}

TEST(RigidOutcome, StopsWhenTheCallerWants) {
  double last = -1;
  const Trajectory t = simulate(block(0.2, {0.5, 0.4}, 0.5), {}, [&](double now) {
    EXPECT_GE(now, last);
    last = now;
    return now < 0.2;
  });
  EXPECT_EQ(t.outcome, Outcome::interrupted);
  EXPECT_NE(t.note.find("stopped by the caller at t = 0.2"), std::string::npos) << t.note;
  EXPECT_NEAR(t.frames.back().t, 0.2, 1.01 / 100);  // a frame more or less: which one is at 0.2 s hangs on rounding
}

TEST(RigidOutcome, SaysWhatStalledARun) {
  RigidProblem p = block(0.2, {0.5, 0.4}, 0.1);
  p.load = [](double t, const BodyState&) { return Load{{t > 0.05 ? std::nan("") : 0, 0, 0}, {0, 0, 0}}; };
  Trajectory t = simulate(p);
  EXPECT_EQ(t.outcome, Outcome::stalled);
  EXPECT_NE(t.note.find("not finite"), std::string::npos) << t.note;

  p = block(0.2, {0.5, 0.4}, 0.3);  // slides on the floor into a wall
  p.V_WB.v = x_axis;
  RigidSupport wall = p.supports[0];
  wall.surface = make_plane(0.05 * x_axis, -x_axis);
  p.supports.push_back(wall);
  t = simulate(p);
  EXPECT_EQ(t.outcome, Outcome::stalled);
  EXPECT_NE(t.note.find("impact"), std::string::npos) << t.note;
  EXPECT_NEAR(t.frames.back().t, 0.05, 0.01);

  t = simulate(block(0.2, {0.5, 0.4}, 1), {1e-10, 1e-3, 100, 10});
  EXPECT_EQ(t.outcome, Outcome::stalled);
  EXPECT_NE(t.note.find("step limit of 10"), std::string::npos) << t.note;
}

TEST(RigidRuns, GiveTheSameBitsAgain) {
  RigidProblem p = ball(0.3, 0.04, 0.4, 0.3, 0.4);
  p.V_WB = {{3, -20, 5}, {1.5, 0.4, 0}};
  const Trajectory a = simulate(p), b = simulate(p);
  ASSERT_EQ(a.frames.size(), b.frames.size());
  EXPECT_EQ(a.steps, b.steps);
  for (std::size_t i = 0; i < a.frames.size(); ++i) {
    EXPECT_EQ(a.frames[i].body.X_WO.p, b.frames[i].body.X_WO.p);
    EXPECT_EQ(a.frames[i].body.X_WO.R.coeffs(), b.frames[i].body.X_WO.R.coeffs());
    EXPECT_EQ(a.frames[i].energy.dissipated, b.frames[i].energy.dissipated);
  }
}

}  // namespace
}  // namespace handhold::reference::rigid::testing
