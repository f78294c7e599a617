// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/hand/phalanx_depth.hpp"

#include <limits>

namespace handhold {
namespace {

/// The deepest point so far; `radius` is the skin's distance from the points looked at.
struct Deepest {
  const VoxelField& field;
  double radius;
  PhalanxDepth found{-std::numeric_limits<double>::infinity(), {0, 0, 0}, {0, 0, 1}};

  void look(const Eigen::Vector3d& p_O) {
    const DistanceSample at = field.distance(p_O);
    if (radius - at.distance <= found.depth) return;
    const double norm = at.gradient.norm();
    if (norm > 0) found.n_O = at.gradient / norm;
    found.depth = radius - at.distance;
    found.skin_O = p_O - radius * found.n_O;
  }
};

}  // namespace

PhalanxDepth phalanx_depth(const PhalanxShape& shape, const Pose& X_OP, const VoxelField& field) {
  if (const auto* capsule = std::get_if<Capsule>(&shape)) {
    constexpr int half_count = 4;
    Deepest deepest{field, capsule->radius};
    for (int i = -half_count; i <= half_count; ++i)
      deepest.look(X_OP * Eigen::Vector3d(0, 0, capsule->half_length * i / half_count));
    return deepest.found;
  }
  constexpr int half_count = 3;
  const Eigen::Vector3d& half = std::get<PalmBox>(shape).half_extents;
  Deepest deepest{field, 0};
  for (const int side : {-1, 1})
    for (int i = -half_count; i <= half_count; ++i)
      for (int k = -half_count; k <= half_count; ++k)
        deepest.look(X_OP * Eigen::Vector3d(half.x() * i / half_count, half.y() * side, half.z() * k / half_count));
  return deepest.found;
}

}  // namespace handhold
