// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/engines.hpp"

namespace handhold::compare {
namespace {

/// A cube that thumb and index, 3 mm deep on both sides, carry up at 0.2 m/s.
Scene carried() {
  using catalogue::edge;
  Scene scene;
  scene.name = "carried";
  scene.duration = 0.5;
  scene.bodies = {catalogue::block({edge, edge, edge}, 1.0 / 512, 0.2, {})};
  const HandModel model = anatomical_hand();
  const auto up = [](double t) -> Eigen::Vector3d { return 0.2 * t * Eigen::Vector3d::UnitZ(); };
  std::vector<catalogue::MovingPatch> patches{{palm, {{0.3, 0, 0}}, {}, up}};
  for (const int phalanx : {2, 5}) {
    const double side = phalanx == 2 ? -1 : 1, radius = model.capsules[std::size_t(phalanx)].radius;
    patches.push_back({phalanx, {{0, side * (edge / 2 + radius - 0.003), 0}}, {}, up});
  }
  scene.hands = {catalogue::hand_of(patches, scene.duration)};
  scene.hands[0].given.clear();
  return scene;
}

TEST(BaselineEngines, RecordAGraspThatFollowsTheHand) {
  for (const char* name : {"kinematic-grasp", "pinch-state"}) {
    const auto engine = make_engine(name);
    ASSERT_TRUE(engine);
    EXPECT_EQ(engine->info({}).name, name);
    const Recording r = engine->play(carried(), {.frame_rate = 90});
    EXPECT_EQ(r.outcome, Outcome::complete);
    ASSERT_EQ(r.frames.size(), 46u);
    EXPECT_EQ(r.frames.back().contacts.size(), 2u);
    // Rigid to the hand from t = 0; 1e-6 m: the end effect of the motion's splines.
    EXPECT_NEAR(r.frames.back().bodies[0].X_WO.p.z(), 0.1, 1e-6) << name;
    EXPECT_NEAR(r.frames.back().bodies[0].V_WO.v.z(), 0.2, 1e-5) << name;
    const Energy e = r.frames.back().energy;
    EXPECT_NEAR(e.kinetic + e.potential - e.hand_work, 0, 1e-12);
  }
}

TEST(BaselineEngines, RefuseAFrameRateThatIsNone) {
  EXPECT_THROW((void)make_engine("pinch-state")->play(carried(), {.frame_rate = 0}), InputError);
}

TEST(BaselineEngines, AreNotAskedAboutGivenSamplePoints) {
  Scene given = carried();
  given.hands[0].given = {{2, {{0, 0, 0}}, {}}};
  EXPECT_EQ(make_engine("pinch-state")->why_not(carried()), "");
  EXPECT_NE(make_engine("pinch-state")->why_not(given), "");
}

}  // namespace
}  // namespace handhold::compare
