// SPDX-License-Identifier: GPL-3.0-or-later
// The law at edges, corners and thin walls: closed forms on exact triangles, and the plates and plateaus around them.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "cases/catalogue/scenes/edge_scenes.hpp"
#include "tests/reference/scenes.hpp"

namespace handhold::reference {
namespace {

using catalogue::EdgeScene;
using closed_form::EdgeContact;
using Eigen::Vector2d;
using Eigen::Vector3d;
using namespace testing;

constexpr double mm = 1e-3, voxel = 1e-3;
constexpr double right_angle = std::numbers::pi / 2;

/// Forces of 0.1 to 1 N at rest, by an integrator that errs by 1e-10 m a step: k times that, some steps of it.
constexpr double force_error = 1e-7;  // [N]

/// Accuracy times some thousand steps [m].
constexpr double length_error = 1e-7;

/// Frames at 1 kHz, so that every arrival of a scene is one.
Options fine() { return {.frame_rate = 1000}; }

Recording play(const EdgeScene& edge) {
  Recording r = simulate(edge.scene, fine());
  EXPECT_EQ(r.outcome, Outcome::complete) << r.note;
  EXPECT_LT(energy_residual(r), 1e-9);
  return r;
}

const ContactState& contact_at(const Recording& r, double t) {
  const auto frame = std::min_element(r.frames.begin(), r.frames.end(), [&](const Frame& a, const Frame& b) {
    return std::abs(a.t - t) < std::abs(b.t - t);
  });
  return frame->contacts.at(0);
}

Vector3d force_at(const Recording& r, double t) { return contact_at(r, t).f_W; }

double time_of_last(const Recording& r, EventKind kind) {
  const auto found = std::find_if(r.events.rbegin(), r.events.rend(), [&](const Event& e) { return e.kind == kind; });
  return found == r.events.rend() ? std::nan("") : found->t;
}

double speed_x(const EdgeScene& scene, double t) { return scene.velocity(t).x(); }

// E1, E2
TEST(Edge, LetsGoBeyondAConvexEdgeWhereItShould) {
  for (const double turn : {right_angle, std::numbers::pi / 3, 110 * std::numbers::pi / 180}) {
    const EdgeScene scene = catalogue::dragged_over(turn, 2 * mm, voxel);
    const double t = time_of_last(play(scene), EventKind::release);
    const double expected = closed_form::leaves_convex_edge({}, 2 * mm, turn, speed_x(scene, t));
    EXPECT_NEAR(scene.path(t).x(), expected, length_error) << turn;
  }
}

// E3
TEST(Edge, PressesBesideAConvexEdgeAsAnywhere) {
  const double degree = std::numbers::pi / 180;
  struct Pressed {
    double beside, tilt;
  };
  for (const Pressed& p : {Pressed{0.1 * mm, 0}, Pressed{0.1 * mm, 20 * degree}, Pressed{0.4 * mm, 35 * degree}}) {
    const EdgeScene scene = catalogue::pressed_beside(p.beside, 4 * mm, p.tilt, voxel);
    const Vector3d f = force_at(play(scene), scene.arrivals[0]);
    const Vector2d expected = closed_form::pressed({}, 4 * mm, p.tilt);
    EXPECT_NEAR(f.x(), expected.x(), force_error) << p.tilt;
    EXPECT_NEAR(f.z(), expected.y(), force_error) << p.tilt;
  }
}

// E4
TEST(Edge, HoldsOutsideOfTheEdgeAndBack) {
  const EdgeScene scene = catalogue::led_outside(voxel);
  const Recording r = play(scene);
  EXPECT_LT((force_at(r, scene.arrivals[1]) - closed_form::held({}, {1.5 * mm, 0, -4 * mm})).norm(), 1e-9);
  EXPECT_LT((force_at(r, scene.arrivals[2]) - closed_form::held({}, {0, 0, -4 * mm})).norm(), 1e-9);
}

// E5
TEST(Edge, ComesBackInThroughTheSide) {
  const EdgeScene scene = catalogue::back_in(voxel);
  EXPECT_LT((force_at(play(scene), scene.arrivals[2]) - closed_form::held({}, {-2 * mm, 0, 0})).norm(), force_error);
}

// E6
TEST(Edge, IsCaughtInAHollowEdgeAndLeavesIt) {
  const EdgeScene scene = catalogue::into_hollow_edge(voxel);
  const Recording r = play(scene);
  EXPECT_LT((force_at(r, scene.arrivals[1]) - closed_form::held({}, {-3 * mm, 0, -2 * mm})).norm(), force_error);
  const double t = time_of_last(r, EventKind::breakaway);
  EXPECT_NEAR(scene.path(t).x(), closed_form::leaves_hollow_edge({}, 2 * mm, speed_x(scene, t)), length_error);
  const double lag = closed_form::drag({}, 2 * mm) / EdgeContact().stiffness;
  EXPECT_NEAR(contact_at(r, scene.arrivals[2]).C_W.x(), 6 * mm - lag, length_error);
}

// E7
TEST(Edge, SlidesAlongAGroove) {
  const EdgeScene scene = catalogue::along_groove(voxel);
  const Recording r = play(scene);
  EXPECT_NEAR(force_at(r, scene.arrivals[2]).y(), closed_form::groove_drag({}, 2 * mm, 2 * mm), force_error);
  const Vector3d C = contact_at(r, scene.arrivals[2]).C_W;
  EXPECT_LT(std::hypot(C.x(), C.z()), 1e-15);  // on the edge, to round-off
}

// E8
TEST(Edge, IsHeldInAHollowCornerAndLeavesAlongAnEdge) {
  const EdgeScene scene = catalogue::into_hollow_corner(voxel);
  const Recording r = play(scene);
  EXPECT_LT((force_at(r, scene.arrivals[1]) - closed_form::held({}, {-2 * mm, -3 * mm, -2 * mm})).norm(), force_error);
  EXPECT_NEAR(force_at(r, scene.arrivals[2]).z(), closed_form::groove_drag({}, 2 * mm, 3 * mm), force_error);
}

// M7: 2.2 mm below the face it came through, 1.8 mm above the other.
TEST(Edge, KeepsItsSheetWhenTheDamperLetsGo) {
  const EdgeScene scene = catalogue::released_in_plate(voxel);
  const Recording r = play(scene);
  EXPECT_EQ(
      std::count_if(r.events.begin(), r.events.end(), [](const Event& e) { return e.kind == EventKind::release; }), 1);
  EXPECT_LT((force_at(r, scene.arrivals[1]) - Vector3d(0, 0, -0.22)).norm(), force_error);
}

// The end of a hollow edge is a saddle corner: outside of the end face nothing holds the sample any more.
TEST(Edge, LetsGoBeyondTheEndOfAGroove) {
  const double d = 2 * mm, half = 30 * mm;
  const EdgeScene scene =
      catalogue::edge_scene("over the end of a groove", catalogue::hollow_edge(), voxel, {}, {3 * mm, 25 * mm, 1 * mm},
                            {{0.3, {3 * mm, 25 * mm, -d}}, {0.5, {-d, 25 * mm, -d}}, {1, {-d, 35 * mm, -d}}});
  const double lag = closed_form::groove_drag({}, d, d) / EdgeContact().stiffness;
  EXPECT_NEAR(scene.path(time_of_last(play(scene), EventKind::release)).y(), half + lag, length_error);
}

// c = 0: what the damped law does as its damping goes to 0. Nothing depends on a speed.
TEST(Edge, DoesTheSameWithoutDamping) {
  EdgeContact undamped;
  undamped.damping = 0;
  const double d = 2 * mm, y = 0.1 * mm;
  const EdgeScene convex = catalogue::dragged_over(std::numbers::pi / 3, d, voxel, undamped);
  EXPECT_NEAR(convex.path(time_of_last(play(convex), EventKind::release)).x(),
              closed_form::leaves_convex_edge(undamped, d, std::numbers::pi / 3), length_error);
  const EdgeScene hollow =
      catalogue::edge_scene("hollow", catalogue::hollow_edge(), voxel, undamped, {10 * mm, y, 1 * mm},
                            {{0.3, {10 * mm, y, -d}}, {1, {-3 * mm, y, -d}}, {1, {6 * mm, y, -d}}});
  const Recording in_and_out = play(hollow);
  EXPECT_LT((force_at(in_and_out, hollow.arrivals[1]) - closed_form::held(undamped, {-3 * mm, 0, -d})).norm(), 1e-7);
  EXPECT_NEAR(hollow.path(time_of_last(in_and_out, EventKind::breakaway)).x(),
              closed_form::leaves_hollow_edge(undamped, d), length_error);
  const EdgeScene corner =
      catalogue::edge_scene("corner", catalogue::hollow_corner(), voxel, undamped, {10 * mm, 9 * mm, 1 * mm},
                            {{0.3, {10 * mm, 9 * mm, -d}}, {1, {-d, -3 * mm, -d}}, {1, {-d, -3 * mm, 5 * mm}}});
  const Recording out = play(corner);
  EXPECT_LT((force_at(out, corner.arrivals[1]) - closed_form::held(undamped, {-d, -3 * mm, -d})).norm(), force_error);
  EXPECT_NEAR(force_at(out, corner.arrivals[2]).z(), closed_form::groove_drag(undamped, d, 3 * mm), force_error);
}

/// A smooth path of sines within `reach` of the origin, another one for every seed.
std::function<Vector3d(double)> wander(unsigned seed, double reach) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  std::array<Vector3d, 3> amplitude, phase;
  for (std::size_t i = 0; i < 3; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      amplitude[i][axis] = reach / 3 * unit(random);
      phase[i][axis] = 2 * std::numbers::pi * unit(random);
    }
  return [=](double t) {
    Vector3d p = Vector3d::Zero();
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis)
        p[axis] += amplitude[std::size_t(i)][axis] * std::sin((3.0 + 4 * i) * t + phase[std::size_t(i)][axis]);
    return p;
  };
}

// f . v − V' >= 0 whatever the path does at edges and corners, with damping and without: the book closes with what is
// dissipated, and that never falls.
TEST(Edge, NeverGivesEnergy) {
  const std::vector<Mesh> solids{catalogue::convex_edge(right_angle), catalogue::convex_edge(0.5),
                                 catalogue::hollow_edge(), catalogue::hollow_corner()};
  int changes = 0;
  for (std::size_t i = 0; i < solids.size(); ++i)
    for (const double damping : {0.05, 0.0})
      for (unsigned seed = 0; seed < 6; ++seed) {
        EdgeContact contact;
        contact.damping = damping;
        EdgeScene scene = catalogue::edge_scene("wander", solids[i], 2 * voxel, contact, {0, 0, 0}, {{2, {0, 0, 0}}});
        Patch patch;
        patch.phalanx = 5;
        patch.points = {Vector3d::Zero()};
        patch.pose = [path = wander(10 * unsigned(i) + seed, 8 * mm)](double t) {
          return Pose{Eigen::Quaterniond::Identity(), path(t)};
        };
        scene.scene.hands = {hand_with({patch}, scene.scene.duration + 0.1)};
        const Recording r = simulate(scene.scene, fine());
        ASSERT_EQ(r.outcome, Outcome::complete) << i << " " << damping << " " << seed << ": " << r.note;
        EXPECT_LT(energy_residual(r), 1e-9) << i << " " << damping << " " << seed;
        changes += int(r.events.size());
        for (std::size_t k = 1; k < r.frames.size(); ++k)
          EXPECT_GE(r.frames[k].energy.dissipated, r.frames[k - 1].energy.dissipated - 1e-12)
              << i << " " << damping << " " << seed << " at " << r.frames[k].t;
      }
  EXPECT_GT(changes, 500);
}

// On a convex edge the law does not decide; beside it, it does.
TEST(Edge, SaysWhereTheLawDoesNotDecide) {
  const auto touch = [](double beside) { return play(catalogue::pressed_beside(beside, 1 * mm, 0.3, voxel)); };
  const Recording on = touch(0);
  ASSERT_EQ(on.ambiguities.size(), 1u);
  EXPECT_EQ(on.ambiguities[0].t, on.events[0].t);
  EXPECT_EQ(on.ambiguities[0].id, on.events[0].id);
  EXPECT_NE(on.ambiguities[0].what.find("convex edge"), std::string::npos);
  EXPECT_TRUE(touch(0.01 * mm).ambiguities.empty());
}

// Started in the middle of a plate: two sheets are as near.
TEST(Edge, SaysWhereASampleAppearsBetweenTwoSheets) {
  const Mesh plate = catalogue::box_between({-30 * mm, -30 * mm, -2 * mm}, {30 * mm, 30 * mm, 2 * mm});
  for (const double z : {0.0, 0.1 * mm}) {
    const EdgeScene scene =
        catalogue::edge_scene("appears", plate, voxel, {}, {1 * mm, 3 * mm, z}, {{0.01, {1 * mm, 3 * mm, z}}});
    const Recording r = play(scene);
    ASSERT_EQ(r.ambiguities.size(), z == 0 ? 1u : 0u);
  }
}

}  // namespace
}  // namespace handhold::reference
