// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/world.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "cases/model/input_error.hpp"
#include "tests/realtime/allocations.hpp"
#include "tests/realtime/scenes.hpp"

namespace handhold::realtime {
namespace {

using catalogue::edge;
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
const auto still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };

std::vector<HandFrame> frames(const Scene& scene, double t) {
  std::vector<HandFrame> hands(scene.hands.size());
  for (std::size_t i = 0; i < hands.size(); ++i) {
    hands[i].present = true;
    for (int p = 0; p < phalanx_count; ++p) hands[i].X_WP[p] = scene.hands[i].motion->pose(p, t);
  }
  return hands;
}

World started(const Scene& scene, const Options& options, double dt) {
  World world(world_def_of(scene), options);
  for (const double t : {-2 * dt, -dt}) world.observe(dt, frames(scene, t));
  world.start(dt, frames(scene, 0));
  return world;
}

void run(World& world, const Scene& scene, int count, double dt) {
  for (int k = 1; k <= count; ++k) world.advance(dt, frames(scene, k * dt));
}

double book(const World& world) { return energy_sum(world.energy()); }

Scene free_scene() {
  Scene scene;
  scene.name = "free";
  scene.bodies = {catalogue::block({edge, edge, edge}, catalogue::voxel, 0.2, {})};
  return scene;
}

/// A cube held in a pinch of `share` of the critical normal force, springs at the load of gravity.
Scene pinch_scene(double share) {
  Scene scene = free_scene();
  const double k = 800, mu = 0.5, load = 0.2 * 9.81 / 2;
  scene.contact = {.stiffness = 100, .damping = 0.5};
  const SampleStart start{.lag_W = load / k * up};
  scene.hands = {catalogue::hand_of(catalogue::pinch_patches(
                                        edge / 2, share * load / mu / k, start, [](double) { return 0.0; }, still),
                                    1)};
  return scene;
}

/// A cube afloat, and a hand far away but for one fingertip that comes at 0.1 m/s from 10 mm outside the face
/// y = −edge/2, and stops at `until` (3 mm inside if the cube stayed).
struct FingerPush {
  double dt{1.0 / 90};
  Scene scene = free_scene();

  explicit FingerPush(double until = 0.13) {
    scene.gravity.setZero();
    scene.contact.damping = 1;
    const double radius = anatomical_hand().capsules[5].radius;
    const auto path = [until](double t) -> Eigen::Vector3d {
      return std::min(t, until) * 0.1 * Eigen::Vector3d::UnitY();
    };
    const std::vector<catalogue::MovingPatch> patches{{5, {{0, -edge / 2 - radius - 0.01, 0}}, {}, path}};
    scene.hands = {catalogue::hand_of(patches, 1)};
    scene.hands[0].given.clear();
  }
  [[nodiscard]] std::vector<std::vector<HandFrame>> all_frames() const {
    std::vector<std::vector<HandFrame>> all;
    for (int k = 0; k <= 90; ++k) all.push_back(frames(scene, k * dt));
    return all;
  }
};

TEST(World, FallsAsTheExactDiscreteMapSays) {
  const Scene scene = free_scene();
  const double dt = 1.0 / 90;
  World world = started(scene, {.substeps = 4}, dt);
  run(world, scene, 45, dt);
  const double t = 45 * dt, h = dt / 4;
  // R03: semi-implicit Euler under constant force, x = a t²/2 + a t h/2, v = a t. Rounding of 180 steps.
  EXPECT_NEAR(world.body().X_WO.p.z(), -9.81 * (t * t / 2 + t * h / 2), 1e-13);
  EXPECT_NEAR(world.body().v.z(), -9.81 * t, 1e-13);
}

TEST(World, SpinsExactlyAtConstantRate) {
  Scene scene = free_scene();
  scene.gravity.setZero();
  scene.bodies[0].V_WO.w = {3, 4, 12};  // a cube: any axis is principal
  World world = started(scene, {}, 0.01);
  run(world, scene, 100, 0.01);
  const Eigen::Quaterniond R(Eigen::AngleAxisd(13.0, Eigen::Vector3d(3, 4, 12) / 13));
  EXPECT_LT((world.body().X_WO.R.toRotationMatrix() - R.toRotationMatrix()).norm(), 1e-12);  // rounding of 400 products
}

TEST(World, EveryForceLiesInItsConeAndNonePulls) {
  const Scene scene = pinch_scene(0.9);  // slips
  World world = started(scene, {.substeps = 4}, 1.0 / 90);
  int slipping = 0;
  for (int k = 1; k <= 9; ++k) {
    world.advance(1.0 / 90, frames(scene, k / 90.0));
    for (std::size_t i = 0; i < world.contacts().size(); ++i) {
      const ContactState c = world.contact(i);
      const double N = -c.f_W.dot(c.n_W);
      const double t = (c.f_W + N * c.n_W).norm();
      EXPECT_GE(N, 0);
      const double mu = c.mode == Mode::slip ? 0.4 : 0.5;
      EXPECT_LE(t, mu * N * (1 + 1e-9));  // the frame of n has moved by h ω since the force was computed
      slipping += c.mode == Mode::slip;
    }
  }
  EXPECT_GT(slipping, 0);
}

TEST(World, GivesTheSameBitsAgainAndForAnyOrderOfPhalanges) {
  const Scene scene = pinch_scene(0.95);
  Scene reversed = scene;
  std::reverse(reversed.hands[0].given.begin(), reversed.hands[0].given.end());
  World a = started(scene, {}, 1.0 / 90), b = started(scene, {}, 1.0 / 90), c = started(reversed, {}, 1.0 / 90);
  for (World* world : {&a, &b, &c}) run(*world, scene, 9, 1.0 / 90);
  EXPECT_EQ(a.body().X_WO.p, b.body().X_WO.p);
  EXPECT_EQ(a.body().X_WO.p, c.body().X_WO.p);
  EXPECT_EQ(a.body().X_WO.R.coeffs(), c.body().X_WO.R.coeffs());
}

TEST(World, ASupportCarriesTheWeightUntilItLetsGo) {
  Scene scene = free_scene();
  scene.bodies[0].held_until = 0.1;
  World world = started(scene, {.substeps = 1}, 0.05);
  run(world, scene, 2, 0.05);
  EXPECT_EQ(world.body().X_WO.p.z(), 0);
  run(world, scene, 2, 0.05);
  EXPECT_LT(world.body().X_WO.p.z(), -0.01);
}

/// A finger pushes a body in the oil of its support: k d = m v / τ, so the depth settles at m v / (τ K) for a finger of
/// speed v.
TEST(World, ASupportYieldsAsThickOil) {
  Scene scene = free_scene();
  scene.bodies[0].held_until = 1;
  scene.contact = {.stiffness = 100, .damping = 0};
  const double speed = 0.02;
  const auto push = [=](double t) -> Eigen::Vector3d { return std::max(0.0, t) * speed * up; };
  scene.hands = {catalogue::hand_of({catalogue::palm_patch({}, push)}, 1)};
  scene.bodies[0].X_WO.p.z() = edge / 2;
  World world = started(scene, {.substeps = 8}, 1.0 / 90);
  run(world, scene, 45, 1.0 / 90);
  const double depth = scene.bodies[0].inertia.mass * speed / (support_time * 8 * 100);
  EXPECT_NEAR(world.contact(0).depth, depth,
              1e-3 * depth);  // settled within e^(-K τ t / m) = e^(-20) and a damped ring
  EXPECT_NEAR(world.body().v.z(), speed, 1e-3 * speed);
  const Energy e = world.energy();
  EXPECT_NEAR(energy_sum(e), 0,
              0.05 * e.hand_work);  // first order in h
}

TEST(World, SeedsAPatchWhereAPhalanxComesNear) {
  const FingerPush push;
  World world = started(push.scene, {}, push.dt);
  int touches = 0;
  for (int k = 1; k <= 90; ++k) {
    world.advance(push.dt, frames(push.scene, k * push.dt));
    for (const Event& event : world.events()) touches += event.kind == EventKind::touch;
  }
  EXPECT_EQ(touches, 8);                      // the eight samples of one patch
  EXPECT_GT(world.body().X_WO.p.y(), 0.002);  // pushed along
}

/// The damper would push as soon as k d + c d' > 0, here 1 mm before the surface: 100 N/m · 1 mm = 1 N s/m · 0.1 m/s.
TEST(World, ADamperDoesNotPushBeforeTheSurfaceIsReached) {
  const FingerPush push;
  World world = started(push.scene, {}, push.dt);
  double face = 0;
  for (int k = 1; world.events().empty() && k <= 90; ++k) {
    face = world.body().X_WO.p.y() - edge / 2;
    world.advance(push.dt, frames(push.scene, k * push.dt));
  }
  ASSERT_FALSE(world.events().empty());
  const Event& touch = world.events().front();
  EXPECT_EQ(face, -edge / 2);  // at rest until then
  // The finger is 10 mm away and comes at 0.1 m/s; an event shows at the end of its sub-step.
  EXPECT_GT(touch.t, 0.1);
  EXPECT_LE(touch.t, 0.1 + touch.window);
}

TEST(World, LetsGoOfAHandThatIsLostAndTakesItUpAgain) {
  const FingerPush push(1);
  World world = started(push.scene, {}, push.dt);
  const auto hands = push.all_frames();
  const std::vector<HandFrame> nobody(1);
  const std::size_t before = testing::allocations();
  int touches = 0, releases = 0;
  double slowest = 1, pressed = 0;
  for (int k = 1; k <= 60; ++k) {
    if (k == 11) pressed = book(world);
    const bool lost = k >= 11 && k < 14;  // from 0.111 s on, while it presses
    world.advance(push.dt, lost ? nobody : hands[std::size_t(k)]);
    for (const Event& event : world.events()) {
      touches += event.kind == EventKind::touch;
      releases += event.kind == EventKind::release;
    }
    if (!lost) continue;
    const double speed = world.body().v.y();
    slowest = std::min(slowest, speed);
    EXPECT_NEAR(book(world), pressed, 1e-15) << k;  // what the springs held is lost, and booked as such
    EXPECT_EQ(speed, slowest) << k;                 // nothing pushes, nothing brakes: no gravity
    for (std::size_t i = 0; i < world.contacts().size(); ++i) EXPECT_EQ(world.contact(i).f_W.norm(), 0);
  }
  EXPECT_EQ(testing::allocations(), before);  // seeding, dropping and seeding again included
  EXPECT_GT(slowest, 0);
  EXPECT_GE(touches, 16);  // twice the eight samples of the patch
  EXPECT_GE(releases, 8);
  EXPECT_TRUE(world.body().X_WO.p.allFinite());
}

TEST(World, TakesAPoseThatIsNotFiniteForALostHand) {
  const FingerPush push;
  World lost = started(push.scene, {}, push.dt), broken = lost;
  for (int k = 1; k <= 30; ++k) {
    std::vector<HandFrame> hands = frames(push.scene, k * push.dt);
    const bool bad = k >= 11 && k < 20;
    if (bad) hands[0].present = false;
    lost.advance(push.dt, hands);
    if (bad) hands[0].present = true;
    if (bad) hands[0].X_WP[3].R.x() = std::nan("");
    broken.advance(push.dt, hands);
  }
  EXPECT_EQ(lost.body().X_WO.p, broken.body().X_WO.p);
}

/// Catalogue case F01 with a damper, which there is at work: seen from the body, the lag turns. By symmetry all samples
/// do the same, so that three numbers are all there is: w, and the lag of a sample along and across its radius.
///
///     e' = (μ N t − k e) / c + w x e,  t = t* / |t*|,  t* = k e − c w x r,   I w' = −16 (r x μ N t)
///
/// integrated by classical Runge-Kutta here.
double turned_with_damper(double t_end) {
  const double I = 1e-4, muN = 0.5 * 2 / 8, k = 100, c = 0.5, r = 0.004;
  using State = Eigen::Vector4d;  // angle, w, lag along r, lag across r
  const auto rate = [&](const State& y) -> State {
    const Eigen::Vector2d e = y.tail<2>();
    const Eigen::Vector2d trial(k * e.x(), k * e.y() - c * y[1] * r);
    const Eigen::Vector2d force = muN * trial.normalized();
    const Eigen::Vector2d stretch = (force - k * e) / c + y[1] * Eigen::Vector2d(-e.y(), e.x());
    return {y[1], 16 * r * force.y() / I, stretch.x(), stretch.y()};
  };
  State y(0, 20, 0, 0);
  const double lag = muN / k, h = t_end / 20000;
  y.tail<2>() = Eigen::Vector2d(0.3, -1).normalized() * lag * 1.001;
  for (int i = 0; i < 20000; ++i) {
    const State a = rate(y), b = rate(y + h / 2 * a), d = rate(y + h / 2 * b), f = rate(y + h * d);
    y += h / 6 * (a + 2 * b + 2 * d + f);
  }
  return y[0];
}

TEST(World, ADamperTurnsTheForceOfASpin) {
  const double t = 0.1, lag = 0.5 * 2 / 8 / 100 * 1.001;
  Scene scene = free_scene();
  scene.gravity.setZero();
  scene.contact = {.stiffness = 100, .damping = 0.5};
  scene.bodies[0].friction = {.mu_static = 0.5, .mu_dynamic = 0.5};
  scene.bodies[0].inertia.about_center = 1e-4 * Eigen::Matrix3d::Identity();
  scene.bodies[0].V_WO.w = 20 * Eigen::Vector3d::UnitY();
  auto patches = catalogue::pinch_patches(
      edge / 2, 2.0 / 800, {}, [](double) { return 0.0; }, still);
  for (catalogue::MovingPatch& patch : patches)
    for (const Eigen::Vector3d& p : patch.p_W) {
      const Eigen::Vector3d outward = Eigen::Vector3d(p.x(), 0, p.z()) / 0.004;
      const Eigen::Vector3d across = Eigen::Vector3d::UnitY().cross(outward);
      const Eigen::Vector3d direction = (0.3 * outward - across).normalized();
      patch.start[std::size_t(&p - patch.p_W.data())] = {.lag_W = lag * direction, .slipping = true};
    }
  scene.hands = {catalogue::hand_of(patches, 1)};
  double error[2]{};
  for (const int i : {0, 1}) {
    const int n = i == 0 ? 200 : 400;
    World world = started(scene, {.substeps = 4}, t / n);
    run(world, scene, n, t / n);
    const Eigen::Quaterniond& R = world.body().X_WO.R;
    error[i] = 2 * std::atan2(R.y(), R.w()) - turned_with_damper(t);
  }
  // First order, so that halving the step halves the error: what is left by Richardson is of second order.
  EXPECT_NEAR(2 * error[1] - error[0], 0, 1e-5);
  EXPECT_LT(std::abs(error[0]), 1e-3);  // the bias a t h / 2 of the angle (R03) is 5e-4; as much for arms at the start
}

/// What the book cannot explain is the step's own damping, which falls with it.
TEST(World, TheEnergyBookBalancesToFirstOrder) {
  const Scene scene = pinch_scene(0.9);  // slips, with friction, damping, springs and gravity
  double unexplained[2]{};
  for (const int i : {0, 1}) {
    const int n = i == 0 ? 100 : 200;
    World world = started(scene, {.substeps = 4}, 0.08 / n);
    const double before = book(world);
    run(world, scene, n, 0.08 / n);
    unexplained[i] = book(world) - before;
    EXPECT_LT(std::abs(unexplained[i]), 0.02 * world.energy().dissipated);
  }
  EXPECT_NEAR(unexplained[0] / unexplained[1], 2, 0.1);
}

/// There is nothing to solve for, but the force is felt: k (d + lag) of a sample that is pushed in, at the end of a
/// step.
TEST(World, AHandFeelsAFixedBody) {
  Scene scene;
  scene.name = "fixed";
  scene.contact = {.stiffness = 200, .damping = 0};
  scene.bodies = {testing::ground({0.2, 0.2, 0.05})};
  scene.hands = {testing::finger(
      [](double t) -> Eigen::Vector3d {
        return {0, 0, -0.1 * std::max(t, 0.0)};
      },
      {0, 0, 0.02}, 1)};
  for (const int order : {1, 2}) {
    World world = started(scene, {.substeps = 2, .order = order}, 1.0 / 90);
    run(world, scene, 40, 1.0 / 90);
    double force = 0, depth = 0;
    for (std::size_t i = 0; i < world.contacts().size(); ++i) {
      const ContactState state = world.contact(i);
      if (state.mode == Mode::apart) continue;
      force += state.f_W.z();
      depth += state.depth;
    }
    EXPECT_GT(depth, 1e-3);
    // At θ h of the last step: by half a step's way less for the second order.
    const double late = order == 1 ? 0 : 0.1 / 360;
    const double count = force / (-200 * depth);
    EXPECT_NEAR(count, 1, late * 8 / depth + 1e-9) << order;
    EXPECT_EQ(world.unconverged(), 0);
  }
}

/// All that a hand held it lets go of in the first step without it, and feels no more: free fall from there.
TEST(World, AHandThatIsLostHoldsNothing) {
  Scene scene = pinch_scene(0.5);
  World world = started(scene, {.substeps = 2}, 1.0 / 90);
  run(world, scene, 4, 1.0 / 90);
  std::vector<HandFrame> hands = frames(scene, 4.0 / 90);
  const auto touching = [&] {
    const std::vector<Mode>& modes = world.contacts().mode;
    return std::count_if(modes.begin(), modes.end(), [](Mode mode) { return mode != Mode::apart; });
  };
  ASSERT_GT(touching(), 0);
  for (HandFrame& hand : hands) hand.present = false;
  for (int k = 0; k < 20; ++k) {
    world.advance(1.0 / 90, hands);
    EXPECT_EQ(touching(), 0) << k;
    EXPECT_TRUE(k == 0 || world.events().empty()) << k;
  }
}

TEST(World, RefusesWhatItCannotSimulate) {
  const WorldDef def = world_def_of(free_scene());
  EXPECT_THROW(World(def, {.substeps = 0}), InputError);
  EXPECT_THROW(World(def, {.order = 3}), InputError);
  EXPECT_THROW(World(def, {.longest_bridge = -1}), InputError);
  EXPECT_THROW(World(def, {.longest_turn = 0}), InputError);
}

/// A cube swings about the tips of two fingers that rest: they give no work. What the book has falls with the third
/// power of the turn in a step, over all steps with the second of the step.
TEST(World, AHandAtRestGivesNoWork) {
  const catalogue::BenchmarkScene swing = catalogue::benchmark_scene("S5a");
  const double dt = 1.0 / 90;
  double work[2]{};
  for (const int i : {0, 1}) {
    World world = started(swing.scene, {.substeps = i == 0 ? 1 : 4}, dt);
    for (int k = 1; k <= 180; ++k) {
      world.advance(dt, frames(swing.scene, k * dt));
      work[i] = std::max(work[i], std::abs(world.energy().hand_work));
    }
  }
  const double swings = 0.2 * 9.81 * 0.02;  // m g r [J]
  EXPECT_LT(work[0], 0.25 * swings);
  EXPECT_LT(work[1], work[0] / 10);
  EXPECT_LT(work[1], 0.005 * swings);
}

}  // namespace
}  // namespace handhold::realtime
