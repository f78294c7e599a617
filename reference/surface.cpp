// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/surface.hpp"

#include <cmath>

#include <fmt/format.h>

#include "reference/mesh_surface.hpp"
#include "reference/polyhedron.hpp"
#include "reference/spline_surface.hpp"

namespace handhold::reference {

SurfaceChoice choose_surface(const VoxelField& field, SurfaceModel wanted) {
  if (wanted == SurfaceModel::mesh) return {wanted, "triangles, as asked for"};
  if (wanted == SurfaceModel::voxels) return {wanted, "voxels, as asked for"};
  constexpr double degree = M_PI / 180;
  const Polyhedron solid(field.faces());
  const double sharpest = solid.sharpest() / degree;
  if (solid.has_creases())
    return {SurfaceModel::mesh, fmt::format("triangles, for edges turn by up to {:.3g} degrees", sharpest)};
  return {SurfaceModel::voxels, fmt::format("voxels, for no edge turns by more than {:.3g} degrees ({:.3g} at most)",
                                            crease_angle / degree, sharpest)};
}

std::shared_ptr<const Surface> make_surface(std::shared_ptr<const VoxelField> field, SurfaceModel model) {
  if (choose_surface(*field, model).model == SurfaceModel::mesh) return std::make_shared<MeshSurface>(std::move(field));
  return std::make_shared<SplineSurface>(std::move(field));
}

}  // namespace handhold::reference
