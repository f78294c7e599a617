#include "cases/catalogue/builders/variants.hpp"

#include <utility>

#include <Eigen/Geometry>

#include "cases/catalogue/builders/changed.hpp"

namespace handhold::catalogue {
namespace {

struct Variant {
  const char* name;
  Change change;
};

/// No axis of the turn, and none of the scene after it, lies along an axis of the world.
const std::vector<Variant>& variants() {
  static const std::vector<Variant> all{
      {"turned",
       {.X = {Eigen::Quaterniond(Eigen::AngleAxisd(2, Eigen::Vector3d(2, -1, 3).normalized())), {0.25, -0.5, 0.75}}}},
      {"mirrored", {.mirrored = true}},
      {"reordered", {.renumbered = true, .reversed = true}},
  };
  return all;
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

Run changed(Run run, const Variant& variant, Level level) {
  run.variant = variant.name;
  run.curve.reset();
  run.problem = [old = run.problem, change = variant.change] { return catalogue::changed(old(), change); };
  for (Claim& claim : run.claims) {
    claim.measure = changed(claim.measure, variant.change, level);
    claim.converges = false;
  }
  return run;
}

}  // namespace

Case with_variants(Case plain) {
  const std::vector<Run> runs = plain.runs;
  for (const Variant& variant : variants())
    for (const Run& run : runs) plain.runs.push_back(changed(run, variant, plain.level));
  return plain;
}

}  // namespace handhold::catalogue
