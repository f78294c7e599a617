// SPDX-License-Identifier: Apache-2.0
#include "cases/model/printed_problem.hpp"

#include <cmath>
#include <string>

#include "cases/model/input_error.hpp"
#include "cases/model/patch.hpp"
#include "cases/model/text.hpp"

namespace handhold {
namespace {

[[noreturn]] void reject(const std::string& what, const std::string& rule, const std::string& advice) {
  throw InputError(sentence("printed problem: ", what, ": ", rule, " (", advice, ")"));
}

void require_positive(const std::string& what, double value) {
  if (!(value > 0) || !std::isfinite(value))
    reject(sentence(what, "=", value), "must be finite and > 0", "use SI units");
}

void check_shape(const printed::Shape& shape) {
  if (const auto* slab = std::get_if<printed::Slab>(&shape)) require_positive("half_width", slab->half_width);
  if (const auto* ball = std::get_if<printed::Ball>(&shape)) require_positive("radius", ball->radius);
  const auto* voxels = std::get_if<printed::Voxels>(&shape);
  if (voxels && !voxels->field) reject("voxel shape", "has no field", "voxelize a mesh");
}

void check_body(const PrintedProblem& p) {
  if (!p.X_WO.p.allFinite() || !(std::abs(p.X_WO.R.norm() - 1) < 1e-6))
    reject("X_WO", "must be a finite place and a unit quaternion", "normalise it");
  if (!p.V_WO.v.allFinite() || !p.V_WO.w.allFinite()) reject("V_WO", "must be finite", "check the start velocity");
  if (!p.gravity.allFinite()) reject("gravity", "must be finite", "9.81 downwards is usual");
  if (p.mobility == Mobility::fixed) return;
  require_positive("mass", p.inertia.mass);
  if (p.mobility == Mobility::free && !(p.inertia.about_center.determinant() > 0))
    reject("inertia of a free body", "must be that of a solid", "give it about the centre of mass, or lock rotation");
}

void check_phalanx(const printed::Phalanx& phalanx, const std::string& name) {
  if (phalanx.p_P.empty() || phalanx.p_P.size() > std::size_t(max_samples))
    reject(sentence(name, " with ", phalanx.p_P.size(), " samples"), sentence("needs 1 to ", max_samples),
           "spread them over several phalanges");
  if (!phalanx.start.empty() && phalanx.start.size() != phalanx.p_P.size())
    reject(sentence(name, " with ", phalanx.start.size(), " starts"), sentence("has ", phalanx.p_P.size(), " samples"),
           "give one start a sample, or none");
  if (!phalanx.pose) reject(name, "has no pose", "give X_WP as a function of time");
}

}  // namespace

void printed::validate(const HostOptions& options) {
  if (options.substeps < 1)
    reject(sentence("substeps=", options.substeps), "must be at least 1", "give 1 for a plain step");
}

void validate(const PrintedProblem& p) {
  printed::validate(p.law);
  printed::validate(p.host);
  validate(p.friction);
  check_shape(p.shape);
  check_body(p);
  if (p.phalanges.empty()) reject("no phalanx", "nothing would touch the body", "give one with its pose");
  for (std::size_t i = 0; i < p.phalanges.size(); ++i) check_phalanx(p.phalanges[i], sentence("phalanx ", i));
  require_positive("frame", p.frame);
  if (p.frames < 1) reject(sentence("frames=", p.frames), "must be at least 1", "count the frames to be played");
}

}  // namespace handhold
