// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/measure/quality.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/closed_form/off_centre_pinch.hpp"
#include "cases/hand/trace_builder.hpp"
#include "cases/hand/trace_spline.hpp"

// Every recording here is written by hand, so that what the metrics must find is known.

namespace handhold::compare {
namespace {

using catalogue::BenchmarkScene;

constexpr double degree = std::numbers::pi / 180;
constexpr double half_cube = 0.03;
constexpr double radius = 0.008;
constexpr double overlap = 0.003;

/// A cube between two capsules that lift it by 0.1 m/s from t = 0.
BenchmarkScene grip() {
  BenchmarkScene made;
  made.scene.bodies = {catalogue::block({0.06, 0.06, 0.06}, 0.001, 0.2, {})};
  made.scene.duration = 2;
  HandModel model;
  model.capsules.fill({0.01, radius});
  model.palm_box.half_extents = {0.04, 0.01, 0.04};
  const PoseFunction poses = [](double t) {
    std::array<Pose, phalanx_count> X_WP;
    X_WP.fill({Eigen::Quaterniond::Identity(), {0, 0, -10}});
    const double x = half_cube + radius - overlap;
    X_WP[3].p = {-x, 0, 0.1 * t};
    X_WP[6].p = {x, 0, 0.1 * t};
    return X_WP;
  };
  const Trace trace = sample_trace("lift", Side::right, model, poses, -0.1, 2.1, 200);
  made.scene.hands = {{std::make_shared<TraceSpline>(trace, 0), {}}};
  made.phalanges = {{0, 3}, {0, 6}};
  made.plan = catalogue::GripPlan{.hold_begin = 0.2, .hold_end = 1.2, .shake_begin = 1.4};
  return made;
}

Recording record(double duration, const std::function<std::vector<BodyState>(double)>& bodies) {
  Recording recording;
  for (int k = 0; k <= std::lround(90 * duration); ++k)
    recording.frames.push_back({.t = k / 90.0, .bodies = bodies(k / 90.0)});
  return recording;
}

/// The cube follows the hand but for `slip(t)`.
Recording held(const std::function<Eigen::Vector3d(double)>& slip) {
  return record(2, [&](double t) {
    BodyState cube;
    cube.X_WO.p = Eigen::Vector3d(0, 0, 0.1 * t) + slip(t);
    return std::vector<BodyState>{cube};
  });
}

TEST(GripQuality, ACubeThatMovesWithTheHandIsHeldAsDeepAsItsFingersAre) {
  const GripQuality q = grip_quality(grip(), held([](double) -> Eigen::Vector3d { return {0, 0, 0}; }));
  EXPECT_TRUE(q.held);
  EXPECT_NEAR(q.penetration, overlap, 1e-12);  // exact: a capsule over a plane
  EXPECT_LT(q.creep, 1e-12);                   // the spline's and the sum's rounding
  EXPECT_LT(q.shake_slip, 1e-12);
}

TEST(GripQuality, CreepIsTheSpeedAndSlipTheWay) {
  const Eigen::Vector3d velocity{0, 0.3e-3, -0.4e-3};
  const GripQuality q = grip_quality(grip(), held([&](double t) -> Eigen::Vector3d { return velocity * t; }));
  EXPECT_NEAR(q.creep, 0.5e-3, 1e-12);
  EXPECT_NEAR(q.shake_slip, 0.5e-3 * (2 - 1.4), 1e-12);  // both instants are frames
  EXPECT_NEAR(q.largest_deviation, 0.5e-3 * (2 - 0.2), 1e-12);
  EXPECT_TRUE(q.held);
}

TEST(GripQuality, DepthIsThatOfTheDeeperFinger) {
  const GripQuality q = grip_quality(grip(), held([](double) -> Eigen::Vector3d { return {0.001, 0, 0}; }));
  EXPECT_NEAR(q.penetration, overlap + 0.001, 1e-12);
}

TEST(GripQuality, ACubeThatFallsIsNotHeldAndSaysSoInItsGates) {
  const BenchmarkScene benchmark = grip();
  const Recording recording = held([](double t) -> Eigen::Vector3d { return {0, 0, t > 1.6 ? -0.5 * (t - 1.6) : 0}; });
  EXPECT_FALSE(grip_quality(benchmark, recording).held);
  const std::vector<Gate> gates = quality_gates(benchmark, recording);
  EXPECT_FALSE(passes(gates[0]));                        // held
  EXPECT_TRUE(passes(gates[1])) << sentence(gates[1]);   // depth, measured before it fell
  EXPECT_FALSE(passes(gates[2])) << sentence(gates[2]);  // slip
  EXPECT_TRUE(passes(gates[3])) << sentence(gates[3]);   // creep, too
}

TEST(GripQuality, ARecordingThatEndsEarlyPassesNothing) {
  Recording recording = held([](double) -> Eigen::Vector3d { return {0, 0, 0}; });
  recording.frames.resize(100);
  for (const Gate& gate : quality_gates(grip(), recording)) EXPECT_FALSE(passes(gate)) << gate.quantity;
}

/// A block on a slope of 30 degrees, `lost` of its way short and `aside` beside it.
Recording slid(const BenchmarkScene& benchmark, double share, double aside) {
  const auto& plan = std::get<catalogue::SlidePlan>(benchmark.plan);
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY();
  return record(1, [&, share, aside](double t) {
    std::vector<BodyState> bodies(2);
    bodies[1].X_WO = benchmark.scene.bodies[1].X_WO;
    bodies[1].X_WO.p += t * t * (share * plan.distance * plan.direction_W + aside * y);
    return bodies;
  });
}

TEST(SlideQuality, FindsTheWayAndWhatIsBesideIt) {
  const BenchmarkScene benchmark = catalogue::benchmark_scene("S3-30");
  // The plan's own distance: half of g (sin 30 − 0.5 cos 30), by hand.
  EXPECT_NEAR(std::get<catalogue::SlidePlan>(benchmark.plan).distance, 0.3286, 1e-4);
  const SlideQuality q = slide_quality(benchmark, slid(benchmark, 1.01, 0.002));
  EXPECT_NEAR(q.distance, 1.01 * std::get<catalogue::SlidePlan>(benchmark.plan).distance, 1e-12);
  EXPECT_NEAR(q.lateral, 0.002, 1e-12);
  EXPECT_FALSE(passes(quality_gates(benchmark, slid(benchmark, 1.01, 0))[0]));
  EXPECT_TRUE(passes(quality_gates(benchmark, slid(benchmark, 1.0005, 0))[0]));
  EXPECT_FALSE(passes(quality_gates(benchmark, slid(benchmark, 1, 0.002))[1]));
}

TEST(SlideQuality, BelowTheAngleOfFrictionABlockMustStay) {
  const BenchmarkScene benchmark = catalogue::benchmark_scene("S3-26");
  EXPECT_EQ(std::get<catalogue::SlidePlan>(benchmark.plan).distance, 0);
  Recording recording = slid(benchmark, 0, 0);
  EXPECT_TRUE(passes(quality_gates(benchmark, recording)[0]));
  recording.frames.back().bodies[1].X_WO.p += 2e-4 * std::get<catalogue::SlidePlan>(benchmark.plan).direction_W;
  EXPECT_FALSE(passes(quality_gates(benchmark, recording)[0]));
}

/// A column of two cubes whose upper one sinks by `sink` in the first half second and then creeps by `speed`.
Recording standing(const BenchmarkScene& benchmark, double sink, double speed) {
  return record(benchmark.scene.duration, [&, sink, speed](double t) {
    std::vector<BodyState> bodies;
    for (const Body& body : benchmark.scene.bodies) bodies.push_back({body.X_WO, {}});
    bodies.back().X_WO.p += Eigen::Vector3d(speed * t, 0, -sink * std::min(1.0, t / 0.5));
    return bodies;
  });
}

TEST(TowerQuality, TellsSinkingIntoBalanceFromDrifting) {
  const BenchmarkScene benchmark = catalogue::tower(1, 2, 4);
  const TowerQuality q = tower_quality(benchmark, standing(benchmark, 1e-3, 1e-4));
  EXPECT_NEAR(q.sink, std::hypot(1e-3, 1e-4), 1e-12);  // at 1 s
  EXPECT_NEAR(q.drift, 3e-4, 1e-12);                   // from 1 s to 4 s
  EXPECT_TRUE(q.stands);
  EXPECT_NEAR(q.lowest, 0.02, 1e-12);
  EXPECT_FALSE(passes(quality_gates(benchmark, standing(benchmark, 0, 1e-4))[1]));
  EXPECT_TRUE(passes(quality_gates(benchmark, standing(benchmark, 1e-3, 1e-5))[1]));
  EXPECT_FALSE(passes(quality_gates(benchmark, standing(benchmark, 0, 5e-3))[0]));  // 20 mm: it fell
}

/// Angle and its rate.
using Swing = std::array<double, 2>;

/// I φ'' = −m g l sin φ − T while φ rises, and rest after that if there is friction, over `time` (classical
/// Runge-Kutta, steps of 0.1 ms: good to 1e-11 rad).
Swing swing_on(const closed_form::OffCentrePinch& p, Swing y, double time) {
  const auto rates = [&](const Swing& s) -> Swing {
    return {s[1], (-p.mass * p.gravity * p.arm * std::sin(s[0]) - p.torque) / p.inertia};
  };
  const auto along = [](const Swing& s, double h, const Swing& r) -> Swing {
    return {s[0] + h * r[0], s[1] + h * r[1]};
  };
  const long steps = std::lround(std::ceil(time / 1e-4));
  const double h = time / double(steps);
  for (long i = 0; i < steps; ++i) {
    if (p.torque > 0 && y[1] < 0) return {y[0], 0};  // its weight does not overcome the friction
    const Swing k1 = rates(y), k2 = rates(along(y, h / 2, k1)), k3 = rates(along(y, h / 2, k2)),
                k4 = rates(along(y, h, k3));
    for (int j : {0, 1}) y[j] += h / 6 * (k1[j] + 2 * k2[j] + 2 * k3[j] + k4[j]);
  }
  return y;
}

/// The pendulum of S5 by its equation of motion, its angles times `share`, its pivot off by `slip`.
Recording swung(const BenchmarkScene& benchmark, double torque, double share, const Eigen::Vector3d& slip) {
  const auto& plan = std::get<catalogue::SwingPlan>(benchmark.plan);
  const closed_form::OffCentrePinch pinch{.torque = torque};
  Swing now{-90 * degree, 0};
  bool rests = false;
  return record(benchmark.scene.duration, [&](double t) {
    if (t > 0 && !rests) now = swing_on(pinch, now, 1.0 / 90);
    rests = torque > 0 && t > 0 && now[1] == 0;
    BodyState cube;
    cube.X_WO.R = Eigen::AngleAxisd(share * now[0] + 90 * degree, plan.axis_W);
    cube.X_WO.p = plan.pivot_W + slip - cube.X_WO.R * plan.pivot_O;
    return std::vector<BodyState>{cube};
  });
}

TEST(SwingQuality, HalfPeriodAndSwingAreThoseOfTheEquationOfMotion) {
  const BenchmarkScene benchmark = catalogue::benchmark_scene("S5a");
  const double truth = std::get<catalogue::SwingPlan>(benchmark.plan).half_period;
  EXPECT_NEAR(truth, 0.2647, 5e-5);  // the study's figure
  const SwingQuality q = swing_quality(benchmark, swung(benchmark, 0, 1, {0, 0, 0.0005}));
  EXPECT_NEAR(q.half_period, truth, 1e-4 * truth);  // a straight line between frames: 20 µs at most
  // Frames miss the turn by at most half of 11 ms, where the angle goes like ½ 196 rad/s² t²: 0.17 degrees.
  EXPECT_NEAR(q.swing_left, 90 * degree, 0.2 * degree);
  EXPECT_NEAR(q.pivot_slip, 0.0005, 1e-12);
  for (const Gate& gate : quality_gates(benchmark, swung(benchmark, 0, 1, {0, 0, 0})))
    EXPECT_TRUE(passes(gate)) << sentence(gate);
  EXPECT_FALSE(passes(quality_gates(benchmark, swung(benchmark, 0, 0.8, {0, 0, 0}))[1]));     // 72 degrees left
  EXPECT_FALSE(passes(quality_gates(benchmark, swung(benchmark, 0, 1, {0, 0.0015, 0}))[2]));  // slipped
}

TEST(SwingQuality, WithFrictionItEndsWhereTheEquationOfMotionDoes) {
  const BenchmarkScene benchmark = catalogue::benchmark_scene("S5b");
  const double truth = std::get<catalogue::SwingPlan>(benchmark.plan).turning_angle;
  EXPECT_NEAR(std::abs(truth) / degree, 19.25, 0.005);  // the study's figure
  const std::vector<Gate> as_it_must = quality_gates(benchmark, swung(benchmark, 0.03, 1, {0, 0, 0}));
  EXPECT_TRUE(passes(as_it_must[0])) << sentence(as_it_must[0]);
  EXPECT_FALSE(
      passes(quality_gates(benchmark, swung(benchmark, 0.033, 1, {0, 0, 0}))[0]));  // a tenth too much friction
}

}  // namespace
}  // namespace handhold::compare
