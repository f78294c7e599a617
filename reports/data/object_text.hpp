// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/input/mesh/mesh_import.hpp"

namespace handhold::reports {

/// What was done to a mesh to close it, its doubts, and warnings: a line each, indented.
[[nodiscard]] std::string repair_text(const RepairReport& repair, const std::vector<std::string>& warnings);

/// Size, voxels, volume and inertia of an object for the terminal, then `repair_text`.
[[nodiscard]] std::string voxel_text(const VoxelReport& report);

}  // namespace handhold::reports
