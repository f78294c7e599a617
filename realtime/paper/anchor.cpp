// SPDX-License-Identifier: Apache-2.0
#include "realtime/paper/anchor.hpp"

#include <algorithm>

namespace handhold::realtime::paper {
namespace {

void accept(const std::optional<Spot>& hit, const Options& options, Spot& anchor) {
  if (hit && hit->n_O.dot(anchor.n_O) > options.turned_away) anchor = *hit;
}

}  // namespace

void cast_anchor(const Surface& surface, const Eigen::Vector3d& p_O, const Options& options, Spot& anchor) {
  accept(surface.cast(anchor.C_O + options.ray_offset * anchor.n_O, p_O), options, anchor);
}

void drag_anchor(const Surface& surface, const Eigen::Vector3d& p_O, double mu_dynamic, const Options& options,
                 Spot& anchor) {
  const Eigen::Vector3d reach = p_O - anchor.C_O;
  const double depth = -reach.dot(anchor.n_O);
  const Eigen::Vector3d lag = reach + depth * anchor.n_O;
  const double length = lag.norm(), left = mu_dynamic * std::max(0.0, depth);
  if (!(length > left)) return;
  const Eigen::Vector3d move = (1 - left / length) * lag;
  const Eigen::Vector3d lift = (options.ray_offset + move.norm()) * anchor.n_O;  // surfaces bent up to 45 degrees
  accept(surface.cast(anchor.C_O + move + lift, anchor.C_O + move - lift), options, anchor);
}

}  // namespace handhold::realtime::paper
