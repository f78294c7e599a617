// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "reference/rigid/modes.hpp"

namespace handhold::reference::rigid {

/// Accelerates the body under trial modes.
using Trial = std::function<std::vector<Reaction>(const Modes& modes)>;

/// Below these, a support touches, rests, or does not accelerate.
struct Tolerances {
  double gap{1e-9};           ///< [m]
  double speed{1e-12};        ///< [m/s]
  double acceleration{1e-9};  ///< [m/s²]
};

/// Finds modes that satisfy every inequality of rigid Coulomb friction at the present place and velocity, or nothing if
/// no combination does (or friction makes none possible, as Painlevé showed).
///
/// A support that is open, or opens, is apart; one that slides slips, if it does not leave; one at rest may stick (N >=
/// 0, |f| <= μ_s N), slip (against the friction that would have been needed, u' forward) or leave (gap'' >= 0).
/// Combinations are tried in a fixed order: as much sticking as possible, and equal modes of equal supports before
/// unequal ones, so that a symmetric grip breaks away symmetrically.
[[nodiscard]] std::optional<Modes> settle(const RigidProblem& problem, double t,
                                          const std::vector<ContactPoint>& points, const Trial& trial,
                                          const Tolerances& tolerances);

}  // namespace handhold::reference::rigid
