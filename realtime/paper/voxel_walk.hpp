// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "cases/model/voxel_field.hpp"
#include "realtime/paper/surface.hpp"

namespace handhold::realtime::paper {

// The object as the paper's engine sees it: a heap of cubes, voxel (i, j, k) reaching half a spacing from its node.

/// First face of an occupied voxel on the way from `from_O` to `to_O` (Amanatides & Woo 1987); a start inside an
/// occupied voxel meets nothing until it has left it ("an engine limitation that does not allow for collision detection
/// if a ray originates inside a collider", section 3.5).
[[nodiscard]] std::optional<Spot> cast_voxels(const VoxelField& field, const Eigen::Vector3d& from_O,
                                              const Eigen::Vector3d& to_O);

/// The closest point of a face between an occupied and an empty voxel, within `reach`; the lowest index on ties.
[[nodiscard]] std::optional<Spot> closest_voxel_face(const VoxelField& field, const Eigen::Vector3d& p_O, double reach);

}  // namespace handhold::realtime::paper
