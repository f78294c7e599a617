// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/model/printed_problem.hpp"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "cases/model/input_error.hpp"
#include "cases/model/problem.hpp"

namespace handhold {
namespace {

PrintedProblem good() {
  return {.inertia = {.mass = 1, .about_center = Eigen::Matrix3d::Identity()},
          .phalanges = {{.p_P = {Eigen::Vector3d::Zero()}, .pose = [](double) { return Pose{}; }}},
          .frames = 9};
}

TEST(PrintedProblem, IsOfLevelThreeAndLastsItsFrames) {
  const Problem problem = good();
  EXPECT_EQ(level_of(problem), Level::printed);
  EXPECT_DOUBLE_EQ(duration_of(problem), 0.1);
  EXPECT_NO_THROW(validate(good()));
}

TEST(PrintedProblem, NamesWhatCannotBeSimulated) {
  const std::vector<std::pair<const char*, std::function<void(PrintedProblem&)>>> wrong{
      {"stiffness=0", [](auto& p) { p.law.stiffness = 0; }},
      {"substeps=0", [](auto& p) { p.host.substeps = 0; }},
      {"half_width=0", [](auto& p) { p.shape = printed::Slab{}; }},
      {"radius=-1", [](auto& p) { p.shape = printed::Ball{-1}; }},
      {"no field", [](auto& p) { p.shape = printed::Voxels{}; }},
      {"mass=0", [](auto& p) { p.inertia.mass = 0; }},
      {"inertia of a free body", [](auto& p) { p.inertia.about_center.setZero(); }},
      {"X_WO", [](auto& p) { p.X_WO.p.x() = NAN; }},
      {"V_WO", [](auto& p) { p.V_WO.v.x() = INFINITY; }},
      {"gravity", [](auto& p) { p.gravity.z() = NAN; }},
      {"no phalanx", [](auto& p) { p.phalanges.clear(); }},
      {"0 samples", [](auto& p) { p.phalanges[0].p_P.clear(); }},
      {"2 starts", [](auto& p) { p.phalanges[0].start.resize(2); }},
      {"has no pose", [](auto& p) { p.phalanges[0].pose = nullptr; }},
      {"frame=0", [](auto& p) { p.frame = 0; }},
      {"frames=0", [](auto& p) { p.frames = 0; }}};
  for (const auto& [what, spoil] : wrong) {
    PrintedProblem problem = good();
    spoil(problem);
    try {
      validate(problem);
      ADD_FAILURE() << what << " was taken";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace handhold
