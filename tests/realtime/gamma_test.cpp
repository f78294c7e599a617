// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/gamma.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/model/input_error.hpp"
#include "realtime/paper/host.hpp"
#include "realtime/world.hpp"

namespace handhold::realtime {
namespace {

using catalogue::edge;

constexpr double frame = 1.0 / 90;

GraspDemand demand(double mass) { return {.mass = mass, .volume = edge * edge * edge}; }

TEST(Gamma, IsTheFormula) {
  // 3 · 0.2 · 9.81 / (0.5 · 16 · 0.003); the cube's edge / 10 is 6 mm: not the limit.
  EXPECT_NEAR(auto_stiffness(demand(0.2)), 245.25, 1e-10);
  // A cube of 1 cm is pressed by no more than 1 mm.
  EXPECT_NEAR(working_depth({.mass = 0.01, .volume = 1e-6}), 0.001, 1e-15);
  // What the paper's 100 N/m can carry on 16 samples at 2.5 mm with μ = 0.5: 0.204 kg (L3-06).
  EXPECT_NEAR(auto_stiffness({.mass = 0.2038735983690112, .depth = 0.0025, .margin = 1}), 100, 1e-10);
}

TEST(Gamma, StabilityInFramesDoesNotDependOnTheMass) {
  for (const double mass : {0.01, 1.0, 10.0}) {
    const double K = 16 * auto_stiffness(demand(mass));
    EXPECT_NEAR(K * frame * frame / mass, spring_number(demand(mass), frame), 1e-12);
    EXPECT_LT(K * frame * frame / mass, 2.7);
  }
}

TEST(Gamma, RefusesWhatCannotBeHeld) {
  EXPECT_THROW((void)auto_stiffness(demand(0)), InputError);
  EXPECT_THROW((void)auto_stiffness({.mass = 1, .mu_static = 0}), InputError);
  EXPECT_THROW((void)auto_stiffness({.mass = 1, .samples = 0}), InputError);
  EXPECT_THROW((void)auto_stiffness({.mass = 1, .margin = 0.5}), InputError);
}

/// How far a cube of `mass` is below the fingers after they, 3 mm deep, held it for 0.3 s and lifted it at g / 2 for
/// 0.3 s more. Springs start without lag: the hardest release.
struct Lift {
  double below{};
  int breakaways{};
};

Lift lift(double mass, double stiffness, double damping) {
  Scene scene;
  scene.name = "lift";
  scene.contact = {.stiffness = stiffness, .damping = damping};
  scene.bodies = {catalogue::block({edge, edge, edge}, 1.0 / 512, mass, {.mu_static = 0.5, .mu_dynamic = 0.4})};
  const double T = 0.3, a = 9.81 / 2;
  const auto path = [=](double t) -> Eigen::Vector3d {
    return t < T ? Eigen::Vector3d(Eigen::Vector3d::Zero())
                 : Eigen::Vector3d(a / 2 * (t - T) * (t - T) * Eigen::Vector3d::UnitZ());
  };
  scene.hands = {catalogue::hand_of(catalogue::pinch_patches(
                                        edge / 2, 0.003, {}, [](double) { return 0.0; }, path),
                                    1)};
  World world(world_def_of(scene), {});
  std::vector<HandFrame> hands(1);
  const auto place = [&](double t) {
    hands[0].present = true;
    for (int p = 0; p < phalanx_count; ++p) hands[0].X_WP[std::size_t(p)] = scene.hands[0].motion->pose(p, t);
  };
  for (const double t : {-2 * frame, -frame}) place(t), world.observe(frame, hands);
  place(0);
  world.start(frame, hands);
  Lift result;
  for (int k = 1; k <= 54; ++k) {
    place(k * frame);
    world.advance(frame, hands);
    for (const Event& event : world.events()) result.breakaways += event.kind == EventKind::breakaway;
  }
  result.below = path(54 * frame).z() - world.body().X_WO.p.z();
  return result;
}

/// n springs and dampers side by side on one mass: c n / (2 sqrt(m k n)) is the ratio asked for, whatever n.
TEST(Gamma, TheDampingRatioIsThatOfAllSamplesTogether) {
  for (const int samples : {1, 16, 25}) {
    GraspDemand d = demand(0.3);
    d.samples = samples;
    const double k = 150, c = auto_damping(d, k, 0.7);
    EXPECT_NEAR(c * samples / (2 * std::sqrt(0.3 * k * samples)), 0.7, 1e-15) << samples;
  }
}

TEST(Gamma, AHandLiftsTenGramsAndTenKilograms) {
  for (const double mass : {0.01, 0.1, 1.0, 10.0}) {
    const GraspDemand d = demand(mass);
    const double gamma = auto_stiffness(d);
    const Lift result = lift(mass, gamma, auto_damping(d, gamma, 0.3));
    EXPECT_EQ(result.breakaways, 0) << mass;
    // Sag m (g + a) / K = 1.5 μ d / s = 0.75 mm; ω = 140 /s at ζ = 0.3 has settled to 1e-5 of it within 0.3 s.
    EXPECT_NEAR(result.below, 1.5 * 0.5 * 0.003 / 3, 2e-6) << mass;
  }
}

TEST(Gamma, ThePapersStiffnessDropsTenKilograms) {
  EXPECT_GT(lift(10, 100, 0.5).below, 0.05);
  EXPECT_EQ(lift(0.05, 100, 0.5).breakaways, 0);
}

/// The same in a frame-rate engine behind the paper's middleware: explicit, undamped, 90 Hz.
TEST(Gamma, HoldsBehindTheMiddlewareAtFrameRate) {
  for (const double mass : {0.01, 0.1, 1.0, 10.0}) {
    paper::Options options;
    options.stiffness = auto_stiffness(demand(mass));
    paper::HostBody body;
    body.mass = mass;
    body.mobility = Mobility::translation;
    paper::Host host(paper::Middleware(std::make_shared<paper::SlabSurface>(edge / 2), Eigen::Vector3d::Zero(),
                                       {0.5, 0.4}, options, 2),
                     body, {0, 0, -9.81});
    std::array<Pose, 2> hands;
    hands[0].p.x() = -edge / 2 + 0.003;
    hands[1].p.x() = edge / 2 - 0.003;
    const auto points = catalogue::ring({0, 0, 0}, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ(), 0.004, 8);
    for (int i = 0; i < 2; ++i) host.middleware().seed(i, hands[std::size_t(i)], {}, points, 0.02);
    for (int k = 0; k < 900; ++k) host.advance(frame, hands);
    // Undamped it rings between 0 and the overshoot (m g / K)(1 + 1 / sqrt(1 − w / 4)) <= 3 m g / K = μ d: no slip.
    EXPECT_LE(-host.body().motion.X_WO.p.z(), 0.5 * 0.003);
    EXPECT_GE(-host.body().motion.X_WO.p.z(), -0.5 * 0.003);
  }
}

}  // namespace
}  // namespace handhold::realtime
