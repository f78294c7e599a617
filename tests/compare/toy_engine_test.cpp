// SPDX-License-Identifier: GPL-3.0-or-later
// What it takes to bring an engine of one's own: a class with two functions. The suite judges it by the line of all
// others.
#include <cmath>

#include <gtest/gtest.h>

#include "compare/judge/suite.hpp"
#include "compare/judge/verdict.hpp"

namespace handhold::compare {
namespace {

/// Knows gravity and no contact.
class Ballistics : public Engine {
 public:
  [[nodiscard]] EngineInfo info(const EngineOptions&) const override {
    return {.name = "ballistics", .version = "1", .levels = {Level::compliant}};
  }

  [[nodiscard]] std::string why_not(const Problem& problem) const override {
    return std::get<Scene>(problem).hands.empty() ? "" : "it knows no contact";
  }

  [[nodiscard]] Recording play(const Problem& problem, const EngineOptions& options, const Progress&) const override {
    const Scene& scene = std::get<Scene>(problem);
    Recording recording{.engine = "ballistics", .scene = scene.name};
    const long frames = std::lround(scene.duration * options.frame_rate);
    for (long i = 0; i <= frames; ++i) {
      Frame frame{.t = double(i) / options.frame_rate};
      for (const Body& body : scene.bodies) {
        BodyState state{body.X_WO, body.V_WO};
        state.X_WO.p += frame.t * body.V_WO.v + 0.5 * frame.t * frame.t * scene.gravity;
        state.V_WO.v += frame.t * scene.gravity;
        frame.bodies.push_back(state);
      }
      recording.frames.push_back(frame);
    }
    return recording;
  }
};

TEST(ToyEngine, IsJudgedLikeAnyOther) {
  const Ballistics engine;
  const SuiteResult result = run_suite({&engine}, {.ids = {"A01", "C01"}});
  const Count n = count(result);
  EXPECT_GT(n.graded, 0u);
  EXPECT_GT(n.not_asked, 0u);
  for (const ClaimResult& claim : result.cases.at(0).runs.at(0).claims)
    EXPECT_EQ(claim.judgements.at(0).grade, Grade::within_0_1_percent) << claim.claim.quantity;
  EXPECT_EQ(result.cases.at(1).runs.at(0).claims.at(0).judgements.at(0).why_not, "it knows no contact");
}

}  // namespace
}  // namespace handhold::compare
