// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "compare/engine/sampled_problem.hpp"

namespace handhold::compare::testing {

inline constexpr double g = 9.81;

/// A block that slides at 0.8 m/s on the plane z = 0 with μ = 0.4, and stops.
inline RigidProblem sliding_block(double duration = 0.3) {
  RigidProblem problem;
  problem.mass = 0.2;
  problem.mobility = Mobility::translation;
  problem.gravity = {0, 0, -g};
  problem.V_WB.v.x() = 0.8;
  problem.supports = {{.surface = make_plane({0, 0, 0}, {0, 0, 1}), .friction = {0.4, 0.4}}};
  problem.duration = duration;
  return problem;
}

/// Between two fingers that press and move, under a load, tied to a spring: everything that a file can say.
inline RigidProblem rich_problem() {
  RigidProblem problem = sliding_block(0.1);
  problem.supports.clear();
  for (const double side : {-1.0, 1.0}) {
    const Eigen::Vector3d foot(0, 0.03 * side, 0);
    problem.supports.push_back({.surface = make_plane(foot, {0, -side, 0}),
                                .motion =
                                    [](double t) {
                                      return PathPoint{{0, 0, 0.01 * std::sin(20 * t)},
                                                       {0, 0, 0.2 * std::cos(20 * t)},
                                                       {0, 0, -4 * std::sin(20 * t)}};
                                    },
                                .normal_force = [](double t) { return 5 - t; },
                                .friction = {0.5, 0.4},
                                .point_B = foot});
  }
  problem.springs = {{50, {0.01, 0, 0}, {0, 0, 0.1}, {}}};
  problem.load = [](double t, const BodyState&) { return Load{{0.1 + t, 0, 0}, {0, 0, 0}}; };
  return problem;
}

}  // namespace handhold::compare::testing
