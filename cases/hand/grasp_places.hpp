// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/Core>

#include "cases/model/voxel_field.hpp"

namespace handhold {

/// Two opposite places of an object's surface, between which fingers can take it.
struct GraspPlace {
  Eigen::Vector3d center_O{Eigen::Vector3d::Zero()};  ///< halfway between them [m]
  Eigen::Vector3d n_O{Eigen::Vector3d::UnitZ()};  ///< unit, outward at the first place; the second faces away from it
  double thickness{};                             ///< from the first to the second, through the solid [m]
  double opposition{};                            ///< -n1·n2: 1 where the places face exactly away from each other
  bool narrow{};    ///< a fingertip's ring of samples does not fit on one of them: a rim, the edge of a card
  bool enclosed{};  ///< out from one of them the object comes again within 12 cm: a finger there is inside a cup or a
                    ///< bow
};

/// Places of `field` up to `thickest` [m] thick whose opposition is at least 0.8: from `count` points spread evenly
/// over the surface by area (a fixed sequence: the same every time), a ray through the solid each.
[[nodiscard]] std::vector<GraspPlace> find_grasp_places(const VoxelField& field, double thickest, int count);

}  // namespace handhold
