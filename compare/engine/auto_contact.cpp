// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/auto_contact.hpp"

#include <algorithm>

#include "cases/model/mass_properties.hpp"
#include "realtime/gamma.hpp"

namespace handhold::compare {

ContactParameters auto_contact(const Body& body, const Placement& placement, int samples_a_phalanx) {
  realtime::GraspDemand demand;
  demand.mass = body.inertia.mass;
  demand.volume = solid_properties(body.field->mesh()).volume;
  demand.mu_static = std::max(body.friction.mu_static, 0.05);  // ice: below, no stiffness makes a grip
  demand.margin = std::max(demand.margin, 2 * placement.load);
  if (!placement.touches.empty()) {
    double depth = 0;
    for (const Touch& touch : placement.touches) depth += touch.depth / double(placement.touches.size());
    demand.samples = samples_a_phalanx * int(placement.touches.size());
    demand.depth = std::min(demand.depth, depth);
  }
  const double stiffness = realtime::auto_stiffness(demand);
  return {stiffness, realtime::auto_damping(demand, stiffness, auto_damping_ratio)};
}

}  // namespace handhold::compare
