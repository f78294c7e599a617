// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/closed_form/edge.hpp"
#include "cases/model/mesh.hpp"
#include "cases/model/scene.hpp"

namespace handhold::catalogue {

/// The box with corners `low` and `high`.
[[nodiscard]] Mesh box_between(const Eigen::Vector3d& low, const Eigen::Vector3d& high);

/// A block of 60 mm a side whose face z = 0 ends at the convex edge x = 0, where the surface turns down by `turn`
/// [rad], in (0, π).
[[nodiscard]] Mesh convex_edge(double turn);

/// What is left of a block of 60 mm a side, centred at the origin, without x, z > 0: the floor z = 0 meets the wall
/// x = 0 in a hollow edge along y.
[[nodiscard]] Mesh hollow_edge();

/// The same without x, y, z > 0: three faces meet in a hollow corner at the origin.
[[nodiscard]] Mesh hollow_corner();

/// One sample of a prescribed finger on one fixed body, without gravity. Frames O and W are the same.
struct EdgeScene {
  Scene scene{};
  std::function<Eigen::Vector3d(double t)> path{};      ///< of the sample, in W [m]; at rest before 0 and after the end
  std::function<Eigen::Vector3d(double t)> velocity{};  ///< its derivative [m/s]
  std::vector<double> arrivals{};  ///< when the sample has come to the end of each of its ways, and rests there [s]
};

/// A way of `duration` along a quintic (rest to rest), then a rest of 50 ms.
struct Leg {
  double duration{};                            ///< [s]
  Eigen::Vector3d to{Eigen::Vector3d::Zero()};  ///< in W [m]
};

/// Plays a sample from `start` along `legs` on `mesh`.
[[nodiscard]] EdgeScene edge_scene(const std::string& name, const Mesh& mesh, double voxel_size,
                                   const closed_form::EdgeContact& contact, const Eigen::Vector3d& start,
                                   const std::vector<Leg>& legs);

/// The scenes of closed_form/edge.hpp, in metres; each has k = 100 N/m, c = 0.05 N s/m, μ 0.5 / 0.4 unless told.
/// Pressed to `depth` 5 mm before a convex edge, and dragged 10 mm over it.
[[nodiscard]] EdgeScene dragged_over(double turn, double depth, double voxel_size,
                                     const closed_form::EdgeContact& contact = {});
/// Touches `beside` a right-angled convex edge and is pressed to `depth`, tilted by `tilt` away from it [rad].
[[nodiscard]] EdgeScene pressed_beside(double beside, double depth, double tilt, double voxel_size);
/// Sticks 0.5 mm before a right-angled edge at a depth of 4 mm, is led 1 mm beyond it, and back.
[[nodiscard]] EdgeScene led_outside(double voxel_size);
/// Dragged over a right-angled edge, let go there, and brought back 2 mm deep through the side.
[[nodiscard]] EdgeScene back_in(double voxel_size);
/// At a depth of 2 mm in the floor to 3 mm inside the wall of a hollow edge, and out again to 6 mm in front of it.
[[nodiscard]] EdgeScene into_hollow_edge(double voxel_size);
/// Held in a hollow edge, 2 mm deep in both faces, and drawn 10 mm along it.
[[nodiscard]] EdgeScene along_groove(double voxel_size);
/// To (−2, −3, −2) mm in a hollow corner, and out along z to 5 mm.
[[nodiscard]] EdgeScene into_hollow_corner(double voxel_size);
/// 3.2 mm deep in a plate of 4 mm (|z| <= 2 mm), drawn back by 1 mm so fast that its damper, 10 N s/m, lets go of it
/// there: it rests 2.2 mm below the face through which it came, 1.8 mm above the other.
[[nodiscard]] EdgeScene released_in_plate(double voxel_size);

}  // namespace handhold::catalogue
