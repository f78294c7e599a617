// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "cases/catalogue/scenes/edge_scenes.hpp"
#include "tests/realtime/scenes.hpp"

// One sample at edges and corners against closed forms (cases/closed_form/edge.hpp). What is at rest is exact; when
// something happens is known to one sub-step, so that a place is right to one sub-step's way.

namespace handhold::realtime {
namespace {

using catalogue::EdgeScene;
using closed_form::EdgeContact;
using Eigen::Vector3d;

constexpr double mm = 1e-3;
constexpr double degree = std::numbers::pi / 180;
constexpr double voxel = 0.5 * mm;
constexpr double frame = 1.0 / 200;  // [s]; all arrivals are multiples of it
/// Rounding of positions of 60 mm, times k, and what a rest of 10 frames leaves of c/h / (k + c/h) = 1/11 a step.
constexpr double rounding_force = 1e-9;  // [N]
constexpr std::array<int, 4> all_substeps{1, 4, 16, 64};

const EdgeContact contact{};

/// What became of the sample.
struct Played {
  std::vector<ContactState> arrived{};  ///< as it rests at the end of each of its ways
  std::vector<Event> events{};
  double most_drag{};  ///< before x = 0 while it slips [N]
  long unconverged{};
  double unexplained{};  ///< of the energy book [J]

  /// The last one of a kind; NaN: there was none.
  [[nodiscard]] double last(EventKind kind) const {
    double t = std::nan("");
    for (const Event& e : events)
      if (e.kind == kind) t = e.t;
    return t;
  }
};

Played play(const EdgeScene& edge, int substeps, double dt = frame) {
  World world = testing::started(edge.scene, {.substeps = substeps}, dt);
  Played played;
  std::size_t next = 0;
  for (int k = 1; next < edge.arrivals.size(); ++k) {
    world.advance(dt, testing::frames(edge.scene, k * dt));
    played.events.insert(played.events.end(), world.events().begin(), world.events().end());
    const ContactState state = world.contact(0);
    if (state.mode == Mode::slip && state.p_W.x() < 0)
      played.most_drag = std::max(played.most_drag, std::abs(state.f_W.x()));
    if (k * dt < edge.arrivals[next] - 0.5 * dt) continue;
    played.arrived.push_back(state);
    ++next;
  }
  const Energy e = world.energy();
  played.unexplained = e.elastic + e.dissipated - e.hand_work;
  played.unconverged = world.unconverged();
  return played;
}

/// A place at which something happens is passed by at most one sub-step's way. HandPath is right to a dt² / 12, with
/// accelerations a of 0.1 m/s² at most.
double way_of(double speed, int substeps) { return speed * frame / substeps + 0.1 * frame * frame / 12; }

/// A way of minimum jerk comes to rest with the jerk 60 D/T³, so in its last frame with an acceleration of that times
/// dt: by what a dt²/12 makes of it what slides may stick too early [m].
double early_stick(double way, double duration) { return 60 * way / std::pow(duration, 3) * std::pow(frame, 3) / 12; }

/// E1, E2: where a sample that is dragged over a convex edge is let go.
TEST(Edges, AConvexEdgeIsLeftWhereTheClosedFormSays) {
  for (const double turn : {30 * degree, 60 * degree, 75 * degree, 90 * degree, 110 * degree})
    for (const int substeps : all_substeps) {
      const double depth = 2 * mm;
      const EdgeScene edge = catalogue::dragged_over(turn, depth, voxel);
      const Played played = play(edge, substeps);
      const double t = played.last(EventKind::release);
      ASSERT_FALSE(std::isnan(t)) << turn / degree << " degrees: never let go";
      const double speed = edge.velocity(t).x();
      const double x = edge.path(t).x(), expected = closed_form::leaves_convex_edge(contact, depth, turn, speed);
      const double late = way_of(speed, substeps);
      EXPECT_GT(x, expected - 0.1 * frame * frame / 12) << turn / degree << " degrees, " << substeps << " sub-steps";
      EXPECT_LT(x, expected + late) << turn / degree << " degrees, " << substeps << " sub-steps";
      EXPECT_NEAR(played.most_drag, closed_form::drag(contact, depth), rounding_force);
      EXPECT_EQ(played.unconverged, 0);
    }
}

/// E3: how near a convex edge is does not matter to what is pressed beside it.
TEST(Edges, WhatIsPressedBesideAConvexEdgeDoesNotFeelIt) {
  for (const double beside : {0.01 * mm, 0.1 * mm, 0.4 * mm})
    for (const double tilt : {0.0, 20 * degree, 35 * degree})
      for (const int substeps : all_substeps) {
        const Played played = play(catalogue::pressed_beside(beside, 4 * mm, tilt, voxel), substeps);
        const Eigen::Vector2d expected = closed_form::pressed(contact, 4 * mm, tilt);
        const bool slid = std::tan(tilt) > contact.friction.mu_static;
        const double early = slid ? contact.stiffness * early_stick(5 * mm / std::cos(tilt), 0.5) : 0;
        EXPECT_NEAR(played.arrived[0].f_W.x(), expected.x(), rounding_force + early) << beside << ' ' << tilt;
        EXPECT_NEAR(played.arrived[0].f_W.z(), expected.y(), rounding_force) << beside << ' ' << tilt;
      }
}

/// E4.
TEST(Edges, WhatSticksIsHeldBeyondTheEdge) {
  for (const int substeps : all_substeps) {
    const Played played = play(catalogue::led_outside(voxel), substeps);
    EXPECT_LT((played.arrived[1].f_W - closed_form::held(contact, {1.5 * mm, 0, -4 * mm})).norm(), rounding_force);
    EXPECT_LT((played.arrived[2].f_W - closed_form::held(contact, {0, 0, -4 * mm})).norm(), rounding_force);
  }
}

/// E5.
TEST(Edges, WhatWasLetGoTouchesTheSideItComesThrough) {
  for (const int substeps : all_substeps) {
    const Played played = play(catalogue::back_in(voxel), substeps);
    EXPECT_EQ(played.arrived[1].mode, Mode::apart);
    EXPECT_LT((played.arrived[2].f_W - closed_form::held(contact, {-2 * mm, 0, 0})).norm(), rounding_force);
  }
}

/// E6.
TEST(Edges, AHollowEdgeHoldsAndLetsGo) {
  for (const int substeps : all_substeps) {
    const EdgeScene edge = catalogue::into_hollow_edge(voxel);
    const Played played = play(edge, substeps);
    EXPECT_LT((played.arrived[1].f_W - closed_form::held(contact, {-3 * mm, 0, -2 * mm})).norm(), rounding_force);
    const double t = played.last(EventKind::breakaway);
    const double speed = edge.velocity(t).x();
    const double x = edge.path(t).x(), expected = closed_form::leaves_hollow_edge(contact, 2 * mm, speed);
    EXPECT_GT(x, expected - 0.1 * frame * frame / 12) << substeps;
    EXPECT_LT(x, expected + way_of(speed, substeps)) << substeps;
    const double lag = closed_form::drag(contact, 2 * mm) / contact.stiffness;
    EXPECT_NEAR(played.arrived[2].C_W.x(), 6 * mm - lag, early_stick(9 * mm, 1));
  }
}

/// E7.
TEST(Edges, AGrooveDragsAsAFilletOfNoRadius) {
  for (const int substeps : all_substeps) {
    const Played played = play(catalogue::along_groove(voxel), substeps);
    const double drag = closed_form::groove_drag(contact, 2 * mm, 2 * mm);
    EXPECT_NEAR(played.arrived[2].f_W.y(), drag, contact.stiffness * early_stick(10 * mm, 1)) << substeps;
    EXPECT_NEAR(played.arrived[2].C_W.y(), 5 * mm - drag / contact.stiffness, early_stick(10 * mm, 1));
  }
}

/// E8.
TEST(Edges, AHollowCornerHoldsAndIsLeftAlongItsEdge) {
  for (const int substeps : all_substeps) {
    const Played played = play(catalogue::into_hollow_corner(voxel), substeps);
    const Vector3d held = closed_form::held(contact, {-2 * mm, -3 * mm, -2 * mm});
    EXPECT_LT((played.arrived[1].f_W - held).norm(), rounding_force) << substeps;
    const double drag = closed_form::groove_drag(contact, 2 * mm, 3 * mm);
    EXPECT_NEAR(played.arrived[2].f_W.z(), drag, contact.stiffness * early_stick(7 * mm, 1)) << substeps;
  }
}

/// M7: its own sheet, though the other one is nearer.
TEST(Edges, ADamperThatLetsGoInsideKeepsTheSheet) {
  for (const int substeps : all_substeps) {
    const Played played = play(catalogue::released_in_plate(voxel), substeps, 0.001);
    EXPECT_FALSE(std::isnan(played.last(EventKind::release))) << substeps;
    const Vector3d held = closed_form::held(contact, {0, 0, -2.2 * mm});
    EXPECT_LT((played.arrived[1].f_W - held).norm(), rounding_force) << substeps;
  }
}

/// Edges are the mesh's, not the grid's: voxels of any size give the same, to a sub-step's way.
TEST(Edges, DoNotDependOnTheVoxels) {
  for (const double size : {1 * mm, 0.7 * mm, 0.5 * mm, 0.35 * mm}) {
    const EdgeScene edge = catalogue::dragged_over(90 * degree, 2 * mm, size);
    const Played played = play(edge, 16);
    EXPECT_NEAR(edge.path(played.last(EventKind::release)).x(), 0.8 * mm, way_of(0.02, 16)) << size;
    const Played corner = play(catalogue::into_hollow_corner(size), 4);
    EXPECT_NEAR(corner.arrived[2].f_W.z(), closed_form::groove_drag(contact, 2 * mm, 3 * mm),
                contact.stiffness * early_stick(7 * mm, 1))
        << size;
  }
}

/// The book of energy: what it does not explain falls with the step.
TEST(Edges, TheEnergyBookBalancesToFirstOrder) {
  for (const auto& scene : {catalogue::dragged_over(60 * degree, 2 * mm, voxel), catalogue::into_hollow_edge(voxel),
                            catalogue::into_hollow_corner(voxel)}) {
    double before = 0;
    for (const int substeps : all_substeps) {
      const double unexplained = std::abs(play(scene, substeps).unexplained);
      if (substeps > 1) {
        EXPECT_LT(unexplained, before / 2.5) << scene.scene.name << ' ' << substeps;
      }
      before = unexplained;
    }
  }
}

}  // namespace
}  // namespace handhold::realtime
