// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/closed_form/planar_slide.hpp"
#include "cases/model/scene.hpp"

namespace handhold::catalogue {

/// How a closed_form::PlanarSlide becomes a scene.
struct PlanarLayout {
  Eigen::Vector3d size{Eigen::Vector3d::Constant(1.0 / 16)};  ///< of the block; y is its thickness [m]
  double voxel_size{1.0 / 2048};                              ///< [m]
  Eigen::Vector2d center_B{Eigen::Vector2d::Zero()};          ///< of mass in the block, (z, x) [m]
  double stiffness{1000};                                     ///< k of a sample [N/m]
  Friction friction{};
  std::vector<double> stick_depth{};  ///< of the sticking samples [m]
};

/// Thumb and index press on a block from both sides along y. Every place of the planar model is one sample of each
/// finger; its plane (u, v) is W's (z, x), turns are about +y. Sticking samples come first.
[[nodiscard]] Scene planar_scene(const std::string& name, const closed_form::PlanarSlide& slide,
                                 const PlanarLayout& layout, double duration);

}  // namespace handhold::catalogue
