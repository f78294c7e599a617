// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Hand-made voxel fields: any distance function sampled at the nodes.

#include <algorithm>
#include <functional>
#include <memory>

#include "cases/geometry/shapes.hpp"
#include "cases/geometry/voxelizer.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold::reference::testing {

/// The field of a cube of edge 2 * half, with its distances replaced by those of `distance`, clamped at ±band.
inline std::shared_ptr<const VoxelField> field_of(const std::function<double(const Eigen::Vector3d&)>& distance,
                                                  double half, double h, double band) {
  VoxelField::Data data = voxelize(make_box(Eigen::Vector3d::Constant(2 * half)), {h, band})->data();
  for (int k = 0; k < data.grid.size.z(); ++k)
    for (int j = 0; j < data.grid.size.y(); ++j)
      for (int i = 0; i < data.grid.size.x(); ++i) {
        const double d = std::clamp(distance(data.grid.node(i, j, k)), -data.band, data.band);
        data.distance[data.grid.index(i, j, k)] = float(d);
      }
  return std::make_shared<VoxelField>(data);
}

}  // namespace handhold::reference::testing
