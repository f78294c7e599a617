// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rigid/witnesses.hpp"

namespace handhold::reference::rigid {

std::vector<Witness> witnesses(const RigidProblem& problem, double t, const Modes& modes,
                               const std::vector<Reaction>& reactions) {
  std::vector<Witness> all;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const RigidSupport& support = problem.supports[i];
    const Reaction& r = reactions[i];
    if (modes[i].mode == Mode::apart && support.normal_force) {
      all.push_back({Witness::Kind::loose, -support.normal_force(t), true});
      continue;
    }
    if (modes[i].mode == Mode::apart) {
      all.push_back({Witness::Kind::gap, r.point.gap, r.point.gap_rate < 0});
      continue;
    }
    if (modes[i].mode == Mode::stick) all.push_back({Witness::Kind::cone, cone_margin(support, r), true});
    if (modes[i].mode == Mode::slip) all.push_back({Witness::Kind::ahead, r.point.slip.dot(modes[i].held), true});
    all.push_back({Witness::Kind::normal, r.normal_force, true});
  }
  return all;
}

bool tells(const Witness& before, const Witness& now, double noise) {
  if (!(now.value < 0) || !now.falling) return false;
  const bool may_start_at_zero = now.kind == Witness::Kind::gap || now.kind == Witness::Kind::ahead;
  return !may_start_at_zero || before.value > 0 || now.value < -noise;
}

}  // namespace handhold::reference::rigid
