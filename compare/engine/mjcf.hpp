// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/engine/sampled_problem.hpp"

namespace handhold::compare {

/// The problem as a model for MuJoCo's viewer: body, shapes, planes, springs as tendons, what presses as a plate on a
/// slide with a motor at N(0), and a keyframe with the start. What changes in time stands still, and hollow surfaces
/// are left out, each with a comment in the file. Friction: mu_dynamic, elliptic cones; the rest is MuJoCo's default.
[[nodiscard]] std::string mjcf(const SampledProblem& problem);

}  // namespace handhold::compare
