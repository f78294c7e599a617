// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/placing_text.hpp"

#include <gtest/gtest.h>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/hand/built_grasps.hpp"
#include "cases/model/mass_properties.hpp"
#include "compare/engine/engines.hpp"

namespace handhold::reports {
namespace {

Body heavy_box() {
  const double density = 7000;
  Body body;
  body.name = "box";
  body.field = voxelize(make_shape("box"), {0.002, 0.012});
  const SolidProperties solid = solid_properties(body.field->mesh());
  body.inertia = {density * solid.volume, solid.center, density * solid.inertia};
  body.friction = {0.46, 0.37};
  return body;
}

// Too heavy by far for its springs: the sentence says what would hold, and that is true when played.
TEST(PlacingTrial, SaysWhyAGripCannotCarryAndWhatWould) {
  const Trace trace = built_grasps().at(0);
  compare::PlacingRequest request{.trace = &trace, .body = heavy_box(), .contact = {40, 0.2}, .tried = 2};
  const auto engine = compare::make_engine("realtime");
  const compare::Placing placing = compare::place_by_trial(request, *engine);
  const compare::TriedPlacement& best = placing.tried.front();
  ASSERT_FALSE(best.trial.held);
  ASSERT_TRUE(placing.remedy);
  const std::string why = why_lost(placing, request.body);
  EXPECT_NE(why.find("weight"), std::string::npos) << why;
  ASSERT_TRUE(placing.remedy->stiffness) << why;
  const double factor = *placing.remedy->stiffness / best.contact.stiffness;
  request.contact = {factor * best.contact.stiffness, factor * best.contact.damping};
  const compare::Placing cured = compare::place_by_trial(request, *engine);
  EXPECT_TRUE(cured.tried.front().trial.held) << why;
}

}  // namespace
}  // namespace handhold::reports
