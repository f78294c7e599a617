// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/surface.hpp"

#include "reference/mesh_surface.hpp"
#include "reference/spline_surface.hpp"

namespace handhold::reference {

std::shared_ptr<const Surface> make_surface(std::shared_ptr<const VoxelField> field, SurfaceModel model) {
  if (model == SurfaceModel::mesh) return std::make_shared<MeshSurface>(std::move(field));
  return std::make_shared<SplineSurface>(std::move(field));
}

}  // namespace handhold::reference
