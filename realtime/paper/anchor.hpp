// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "realtime/paper/options.hpp"
#include "realtime/paper/surface.hpp"

namespace handhold::realtime::paper {

/// Section 3.5 and Fig. 3: a ray from C + ε n to p finds the new anchor; it stays where the ray meets nothing, or a
/// part of the surface that is turned away (n_new·n_old <= turned_away): "this ensures that a contact remains in a
/// blocked area". On a flat face the lag e becomes e d / (d + ε), exactly.
void cast_anchor(const Surface& surface, const Eigen::Vector3d& p_O, const Options& options, Spot& anchor);

/// Coulomb's anchor: moves along the surface towards p until the lag is `mu_dynamic` times the depth; stays where that
/// is not on this side of the surface. On a flat face exact; on a curved one the new normal makes it good to first
/// order.
void drag_anchor(const Surface& surface, const Eigen::Vector3d& p_O, double mu_dynamic, const Options& options,
                 Spot& anchor);

}  // namespace handhold::realtime::paper
