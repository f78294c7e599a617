// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/builders/variants.hpp"

#include <utility>

#include <Eigen/Geometry>

#include "cases/catalogue/builders/changed.hpp"

namespace handhold::catalogue {
namespace {

/// No axis of the turn, and none of the scene after it, lies along an axis of the world.
Change another_look() {
  const Eigen::AngleAxisd turn(2, Eigen::Vector3d(2, -1, 3).normalized());
  return {.mirrored = true, .X = {Eigen::Quaterniond(turn), {0.25, -0.5, 0.75}}, .renumbered = true, .reversed = true};
}

Measure changed(Measure measure, const Change& change, Level level) {
  using Kind = Measure::Kind;
  const bool axial = measure.kind == Kind::rotation || measure.kind == Kind::spin || measure.kind == Kind::torque;
  measure.axis = axial ? change.axial(measure.axis) : change.polar(measure.axis);
  measure.point = change.pose({Eigen::Quaterniond::Identity(), measure.point}, 0).p;
  measure.from_last = change.reversed;
  if (level != Level::rigid && measure.phalanx >= 0) measure.phalanx = change.phalanx(measure.phalanx);
  return measure;
}

Run changed(Run run, const Change& change, Level level) {
  run.variant = "turned, mirrored, reordered";
  run.curve.reset();
  run.problem = [old = run.problem, change] { return catalogue::changed(old(), change); };
  for (Claim& claim : run.claims) {
    claim.measure = changed(claim.measure, change, level);
    claim.converges = false;
  }
  return run;
}

}  // namespace

Case with_variants(Case plain) {
  const std::vector<Run> runs = plain.runs;
  for (const Run& run : runs) plain.runs.push_back(changed(run, another_look(), plain.level));
  return plain;
}

}  // namespace handhold::catalogue
