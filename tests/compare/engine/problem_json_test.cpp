// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/problem_json.hpp"

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "compare/engine/mjcf.hpp"
#include "tests/cases/input/expect_input_error.hpp"
#include "tests/compare/engine/problems.hpp"
#include "tests/reports/json_schema.hpp"

namespace handhold::compare::testing {
namespace {

using nlohmann::json;
using reports::schema_fault;

json schema() { return json::parse(std::ifstream(HANDHOLD_PROBLEM_SCHEMA)); }

std::string fault(const std::string& text) { return schema_fault(json::parse(text), schema(), schema()); }

/// A ball between surfaces of all kinds, one of which turns.
SampledProblem ball_problem() {
  RigidProblem problem = sliding_block(0.1);
  problem.mobility = Mobility::free;
  problem.X_WB.p.z() = 0.02;
  problem.supports[0].radius = 0.02;
  problem.supports.push_back({.surface = make_sphere({0, 0, 0}, 0.2, true), .radius = 0.02});
  problem.supports.push_back({.surface = make_cylinder({0, 0, -0.1}, {0, 3, 0}, 0.1), .radius = 0.02});
  SampledProblem sampled = sample(problem, "ball", 0.01);
  SampledMotion& motion = sampled.supports[0].motion;
  for (int k = 0; k <= sampled.steps; ++k) {
    motion.p.push_back({0, 0, 0});
    motion.v.push_back({0, 0, 0});
    motion.q.push_back(Eigen::Quaterniond(Eigen::AngleAxisd(0.1 * k, Eigen::Vector3d::UnitZ())));
    motion.w.push_back({0, 0, 10});
  }
  return sampled;
}

TEST(ProblemJson, FitsItsSchema) {
  EXPECT_EQ(fault(problem_json(sample(sliding_block(), "stop", 0.01))), "");
  EXPECT_EQ(fault(problem_json(sample(rich_problem(), "rich", 0.01))), "");
  EXPECT_EQ(fault(problem_json(ball_problem())), "");
}

TEST(ProblemJson, TheSchemaRefusesWhatIsNoProblem) {
  json wrong = json::parse(problem_json(sample(rich_problem(), "rich", 0.01)));
  wrong["supports"][0].erase("mu_static");
  EXPECT_EQ(fault(wrong.dump()), "/supports/0: lacks mu_static");
  wrong = json::parse(problem_json(ball_problem()));
  wrong["bodies"][0]["p"].erase(0);
  EXPECT_EQ(fault(wrong.dump()), "/bodies/0/p: has too few items");
  wrong = json::parse(problem_json(ball_problem()));
  wrong["step"] = 0;
  EXPECT_EQ(fault(wrong.dump()), "/step: not above the exclusive minimum");
}

TEST(ProblemJson, ComesBackToTheLastBit) {
  for (const SampledProblem& problem : {sample(rich_problem(), "rich \"q\"", 1.0 / 360, 4), ball_problem()}) {
    const std::string text = problem_json(problem);
    const SampledProblem back = read_problem_json(text, "problem.json");
    EXPECT_EQ(problem_json(back), text);
    EXPECT_EQ(back.steps, problem.steps);
    EXPECT_TRUE(back.bodies[0].X_WB.p == problem.bodies[0].X_WB.p);
    EXPECT_EQ(back.supports[1].normal_force, problem.supports[1].normal_force);
    EXPECT_TRUE(back.supports[0].motion.p == problem.supports[0].motion.p);
    EXPECT_TRUE(back.supports[0].motion.w == problem.supports[0].motion.w);
    EXPECT_EQ(back.supports[1].surface.hollow, problem.supports[1].surface.hollow);
  }
}

TEST(ProblemJson, SaysWhatCannotBeRead) {
  expect_input_error([] { return read_problem_json("{", "p.json"); }, {"p.json"});
  json wrong = json::parse(problem_json(sample(rich_problem(), "rich", 0.01)));
  wrong["supports"][0]["normal_force"].erase(0);
  expect_input_error([&] { return read_problem_json(wrong.dump(), "p.json"); }, {"'normal_force' has 10 samples"});
  wrong = json::parse(problem_json(ball_problem()));
  wrong["format"] = "another";
  expect_input_error([&] { return read_problem_json(wrong.dump(), "p.json"); }, {"not of format"});
  wrong["format"] = "handhold-problem 1";
  wrong["bodies"][0].erase("mass");
  expect_input_error([&] { return read_problem_json(wrong.dump(), "p.json"); }, {"mass"});
}

TEST(Sample, TakesEveryFunctionAtEveryStep) {
  const SampledProblem s = sample(rich_problem(), "rich", 0.01);
  ASSERT_EQ(s.steps, 10);
  ASSERT_EQ(s.supports[0].normal_force.size(), 11u);
  EXPECT_EQ(s.supports[0].normal_force[7], 5 - 7 * 0.01);
  EXPECT_EQ(s.supports[0].motion.p[7].z(), 0.01 * std::sin(20 * (7 * 0.01)));
  EXPECT_EQ(s.bodies[0].force[7].x(), 0.1 + 7 * 0.01);
  EXPECT_TRUE(s.bodies[0].torque.empty());
}

TEST(Sample, EndsWithAFrame) {
  EXPECT_EQ(sample(sliding_block(0.3), "s", 0.1).steps, 3);  // 0.3 / 0.1 is a little less than 3
  EXPECT_EQ(sample(sliding_block(0.3), "s", 0.1, 2).steps, 4);
  EXPECT_EQ(sample(sliding_block(0.31), "s", 0.1).steps, 4);
}

TEST(Sample, FindsTheVolumeThatTouchesWhereTheFeetDo) {
  const Primitive cube = sample(sliding_block(), "s", 0.1).bodies[0].shapes.at(0);
  EXPECT_EQ(cube.X_BS.p.z() - cube.half_extents.z(), 0);  // stands on its foot
  const Primitive pinched = sample(rich_problem(), "s", 0.1).bodies[0].shapes.at(0);
  EXPECT_NEAR(pinched.half_extents.y(), 0.03, 1e-17);
  EXPECT_LT(pinched.X_BS.p.norm(), 1e-17);
  EXPECT_EQ(ball_problem().bodies[0].shapes.at(0).radius, 0.02);
  EXPECT_EQ(ball_problem().bodies[0].shapes.size(), 1u);
}

TEST(Sample, RefusesWhatAFileCannotSay) {
  RigidProblem problem = sliding_block();
  problem.load = [](double, const BodyState& body) { return Load{-body.V_WO.v, {0, 0, 0}}; };
  expect_input_error([&] { return sample(problem, "s", 0.01); }, {"depends on the body's motion"});
  expect_input_error([] { return sample(sliding_block(), "s", 0); }, {"step=0"});
  problem = sliding_block();
  problem.mobility = Mobility::free;
  expect_input_error([&] { return sample(problem, "s", 0.01); }, {"give its shape"});
}

TEST(Mjcf, HoldsEveryPart) {
  const std::string xml = mjcf(sample(rich_problem(), "a < b", 0.01));
  for (const char* part :
       {"model=\"a &lt; b\"", "timestep=\"0.01\"", "<body name=\"body\"", "<body name=\"support 1\"",
        "<spatial stiffness=\"50\"", "<motor joint=\"support 0\"/>", "ctrl=\"5 5 \"", "support 0 moves in the problem"})
    EXPECT_NE(xml.find(part), std::string::npos) << part << "\n" << xml;
  EXPECT_NE(mjcf(ball_problem()).find("support 1 is hollow"), std::string::npos);
}

}  // namespace
}  // namespace handhold::compare::testing
