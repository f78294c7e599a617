// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/convergence_text.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace handhold::reports {
namespace {

NamedConvergence sample() {
  NamedConvergence named{"pull", "two samples", {}, {0.5, 0.25}, {"height 1 m"}, {}};
  named.study.position = {1.0, 0.01};
  named.study.rotation = named.study.event_time = {std::nan(""), std::nan("")};
  named.study.runs.resize(2);
  compare::ConvergenceRun& run = named.study.runs[0];
  run.setting.name = "reference, 1e-10";
  run.setting.promise = compare::Gap{1e-7, 1e-6, 1e-6, 0};
  run.error = {2e-7, 3e-9, 4e-10, 2};
  run.steps = 215;
  run.kept = false;
  return named;
}

TEST(ConvergenceText, ShowsErrorsStepsAndABrokenPromise) {
  const std::string text = convergence_rows(sample());
  EXPECT_NE(text.find("pull: two samples\n"), std::string::npos);
  const std::string line = text.substr(text.find("reference, 1e-10"), 110);
  for (const char* part : {"2.0e-07", "3.0e-09", "4.0e-10", "(2)!", "215", "5.0e-01", "BROKEN"})
    EXPECT_NE(line.find(part), std::string::npos) << part << " in " << line;
  EXPECT_NE(text.find("position 1.00"), std::string::npos) << text;
  EXPECT_NE(text.find("rotation none"), std::string::npos);
}

TEST(StiffnessText, SaysWhetherTheLimitIsReached) {
  catalogue::LimitScene scene{.name = "pinch", .quantity = "slip", .unit = "m", .truth = 1};
  const compare::Extrapolation near = compare::extrapolate({1, 4, 16}, {5, 2, 1.25});  // 1 + 4/K
  EXPECT_TRUE(reaches_truth(scene, near));
  EXPECT_NE(stiffness_rows(scene, near).find("within the estimate"), std::string::npos);
  scene.truth = 1.01;
  EXPECT_FALSE(reaches_truth(scene, near));
  EXPECT_NE(stiffness_rows(scene, near).find("OUTSIDE the estimate"), std::string::npos);
}

}  // namespace
}  // namespace handhold::reports
