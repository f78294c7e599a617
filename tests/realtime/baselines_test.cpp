// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/model/input_error.hpp"
#include "realtime/baselines/carried_body.hpp"
#include "realtime/baselines/kinematic_grasp.hpp"
#include "realtime/baselines/pinch_state.hpp"

namespace handhold::realtime::baselines {
namespace {

using catalogue::edge;

constexpr double frame = 1.0 / 90;
constexpr double close_at = 0.3, lift_at = 0.5, open_at = 1.2;

/// 0 before `begin`, 1 from `end` on, even in between.
double ramp(double t, double begin, double end) { return std::clamp((t - begin) / (end - begin), 0.0, 1.0); }

/// A cube on a support until 0.4 s; thumb and index close on it to 3 mm deep by 0.3 s, carry it 0.1 m up and 0.05 m
/// along x by 1.0 s, open by 30 mm each from 1.2 s on. The palm goes with them. `fingers` 1: the index stays away.
Scene script(int fingers = 2) {
  Scene scene;
  scene.name = "script";
  scene.duration = 1.5;
  scene.bodies = {catalogue::block({edge, edge, edge}, 1.0 / 512, 0.2, {})};
  scene.bodies[0].held_until = 0.4;
  const HandModel model = anatomical_hand();
  const auto carry = [](double t) -> Eigen::Vector3d {
    const double s = ramp(t, lift_at, 1.0);
    return (3 - 2 * s) * s * s * Eigen::Vector3d(0.05, 0, 0.1);
  };
  std::vector<catalogue::MovingPatch> patches;
  for (int i = 0; i < 2; ++i) {
    const int phalanx = i == 0 ? 2 : 5;
    const double side = i == 0 ? -1 : 1, radius = model.capsules[std::size_t(phalanx)].radius;
    const double away = i < fingers ? 0.02 : 0.2;
    const Eigen::Vector3d start(0, side * (edge / 2 + radius + away), 0);
    const auto path = [=](double t) -> Eigen::Vector3d {
      const double in = 0.023 * ramp(t, 0.1, close_at) - 0.033 * ramp(t, open_at, 1.3);
      return carry(t) - side * in * Eigen::Vector3d::UnitY();
    };
    patches.push_back({phalanx, {start}, {}, path});
  }
  patches.push_back({palm, {{0.3, 0, 0}}, {}, carry});
  scene.hands = {catalogue::hand_of(patches, scene.duration)};
  scene.hands[0].given.clear();
  return scene;
}

std::vector<HandFrame> hands_at(const Scene& scene, double t) {
  std::vector<HandFrame> hands(1);
  hands[0].present = true;
  for (int p = 0; p < phalanx_count; ++p) hands[0].X_WP[std::size_t(p)] = scene.hands[0].motion->pose(p, t);
  return hands;
}

struct Played {
  double grasped{-1}, released{-1};
  Eigen::Vector3d carried{Eigen::Vector3d::Zero()};  // by 1.1 s
  BodyState end{};
  BodyState at_release{};
};

Played play(Baseline& baseline, const Scene& scene) {
  Played played;
  baseline.start(frame, hands_at(scene, 0));
  for (int k = 1; k <= 135; ++k) {
    const double t = k * frame;
    baseline.advance(frame, hands_at(scene, t));
    for (const Event& event : baseline.events()) {
      if (event.kind == EventKind::touch && played.grasped < 0) played.grasped = event.t;
      if (event.kind == EventKind::release) played.released = event.t, played.at_release = event.body;
    }
    if (k == 99) played.carried = baseline.state(0).X_WO.p;
  }
  played.end = baseline.state(0);
  return played;
}

template <class T>
class Baselines : public ::testing::Test {};
using Both = ::testing::Types<KinematicGrasp, PinchState>;
TYPED_TEST_SUITE(Baselines, Both);

TYPED_TEST(Baselines, PickUpCarryAndRelease) {
  const Scene scene = script();
  TypeParam baseline(scene);
  const Played played = play(baseline, scene);
  EXPECT_GT(played.grasped, 0.1);
  EXPECT_LE(played.grasped, close_at + frame);
  // Rigid to the hand: at 1.1 s it has made the hand's way to the last bit but those of the splines.
  EXPECT_LT((played.carried - Eigen::Vector3d(0.05, 0, 0.1)).norm(), 1e-6);
  EXPECT_GT(played.released, open_at);
  EXPECT_LT(played.released, 1.3);
  // Let go at rest, it falls along the exact parabola.
  const double t = 135 * frame - played.released;
  EXPECT_NEAR(played.end.X_WO.p.z(), played.at_release.X_WO.p.z() + played.at_release.V_WO.v.z() * t - 9.81 * t * t / 2,
              1e-12);
  EXPECT_LT(played.end.X_WO.p.z(), played.at_release.X_WO.p.z() - 0.1);
  EXPECT_EQ(baseline.holder(0), -1);
}

TYPED_TEST(Baselines, OneFingerGraspsNothing) {
  const Scene scene = script(1);
  TypeParam baseline(scene);
  const Played played = play(baseline, scene);
  EXPECT_LT(played.grasped, 0);
  EXPECT_LT(played.end.X_WO.p.z(), -1);  // its support went at 0.4 s
}

TYPED_TEST(Baselines, ContactsAreThePhalangesInside) {
  const Scene scene = script();
  TypeParam baseline(scene);
  baseline.start(frame, hands_at(scene, 0));
  EXPECT_TRUE(baseline.contacts().empty());
  for (int k = 1; k * frame <= 0.45; ++k) baseline.advance(frame, hands_at(scene, k * frame));
  const std::vector<ContactState> contacts = baseline.contacts();
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_EQ(contacts[0].id.phalanx, 2);
  EXPECT_EQ(contacts[1].id.phalanx, 5);
  for (const ContactState& c : contacts) {
    EXPECT_EQ(c.mode, Mode::stick);
    EXPECT_NEAR(c.depth, 0.003, 1e-6);
    EXPECT_NEAR(std::abs(c.n_W.y()), 1, 1e-9);
  }
}

TYPED_TEST(Baselines, AHandThatIsLostLetsGo) {
  const Scene scene = script();
  TypeParam baseline(scene);
  baseline.start(frame, hands_at(scene, 0));
  for (int k = 1; k * frame <= 0.6; ++k) baseline.advance(frame, hands_at(scene, k * frame));
  EXPECT_EQ(baseline.holder(0), 0);
  std::vector<HandFrame> lost(1);
  baseline.advance(frame, lost);
  EXPECT_EQ(baseline.holder(0), -1);
}

TEST(KinematicGraspRule, ThresholdAndHysteresis) {
  const Scene scene = script();
  // Squeeze at 3 mm is 800 · 0.003 = 2.4 N; more cannot be reached.
  KinematicGrasp unreachable(scene, {.threshold = 2.5});
  EXPECT_LT(play(unreachable, scene).grasped, 0);
  KinematicGrasp late(scene, {.threshold = 2.3}), early(scene, {.threshold = 0.1});
  EXPECT_GT(play(late, scene).grasped, play(early, scene).grasped);
  KinematicGrasp keen(scene, {.threshold = 1, .release_share = 0.9}),
      slack(scene, {.threshold = 1, .release_share = 0});
  EXPECT_LE(play(keen, scene).released, play(slack, scene).released < 0 ? 2 : play(slack, scene).released);
  EXPECT_THROW(KinematicGrasp(scene, {.threshold = 0}), InputError);
  EXPECT_THROW(PinchState(scene, {.grasp_distance = 0.002, .release_distance = 0.001}), InputError);
}

TEST(PinchStateRule, TwoFingersOnTheSameSidePinchNothing) {
  Scene scene = script();
  const double radius = anatomical_hand().capsules[2].radius;
  const auto still = [](double) -> Eigen::Vector3d { return Eigen::Vector3d::Zero(); };
  std::vector<catalogue::MovingPatch> patches;
  for (const int phalanx : {2, 5})
    patches.push_back({phalanx, {{phalanx == 2 ? -0.015 : 0.015, edge / 2 + radius - 0.003, 0}}, {}, still});
  scene.hands = {catalogue::hand_of(patches, scene.duration)};
  scene.hands[0].given.clear();
  PinchState strict(scene), lax(scene, {.opposition = -1});
  EXPECT_LT(play(strict, scene).grasped, 0);
  EXPECT_EQ(play(lax, scene).released, -1);
  EXPECT_EQ(lax.holder(0), 0);
}

TEST(PinchStateRule, HoldsUntilTheHysteresisIsPassed) {
  const Scene scene = script();
  PinchState narrow(scene, {.release_distance = 0.002}), wide(scene, {.release_distance = 0.009});
  // Both tips leave at 0.33 m/s: 7 mm more take 21 ms, two frames.
  EXPECT_NEAR(play(wide, scene).released - play(narrow, scene).released, 0.021, 1.5 * frame);
}

/// V_WO is of the origin: a body that spins about its centre of mass, 0.1 m off, has its origin go round.
TEST(Baselines, AThrownBodyKeepsTheSpeedOfItsCentre) {
  Body body;
  body.inertia = {.mass = 2, .center = {0.1, 0, 0}, .about_center = Eigen::Matrix3d::Identity()};
  body.V_WO = {{0, 0, 5}, {1, -0.5, 0.2}};  // the centre's: (1, 0, 0.2)
  CarriedBody carried(body);
  EXPECT_LT((carried.state().V_WO.v - body.V_WO.v).norm(), 1e-15);
  EXPECT_NEAR(carried.kinetic(), 0.5 * 2 * 1.04 + 0.5 * 25, 1e-14);
  for (int i = 0; i < 10; ++i) carried.fly(Eigen::Vector3d::Zero(), 1, 0.05);
  const Pose& X = carried.state().X_WO;
  EXPECT_LT((X * body.inertia.center - Eigen::Vector3d(0.6, 0, 0.1)).norm(), 1e-14);
}

}  // namespace
}  // namespace handhold::realtime::baselines
