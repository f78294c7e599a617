// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "tests/reference/independent/slider.hpp"

namespace handhold::independent {

struct Settings {
  Real tolerance{1e-14L};  ///< of a step [m, m/s, rad]
  int columns{5};          ///< of the extrapolation: order 10
  int steps_per_knot{1};   ///< longest step, as a part of the knot spacing of the hand
  Real knot{1 / 2000.0L};  ///< spacing of the hand's knots, at multiples of it [s]; no step passes one
};

struct Happening {
  Real t{};
  SampleId id{};
  EventKind kind{};
};

struct Result {
  Vec3 p_WO{Vec3::Zero()};
  Quat R_WO{Quat::Identity()};
  std::vector<Happening> events{};
  long steps{}, evaluations{};
};

/// Which surface a sample touches, from where it is in O at t = 0.
using SurfaceChoice = std::function<std::shared_ptr<const Surface>(const Vec3& p_O)>;

/// The face of the field's box that the sample is nearest to.
[[nodiscard]] SurfaceChoice nearest_face(const VoxelField& field);

/// Runs a scene with one free body, given patches and one unbroken presence of each hand. The body's states are its
/// centre of mass, the velocity of that, a quaternion and the angular momentum in W. Throws std::runtime_error when it
/// cannot go on.
[[nodiscard]] Result solve(const Scene& scene, const SurfaceChoice& surface, const Settings& settings = {});

}  // namespace handhold::independent
