// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "cases/model/pose.hpp"
#include "cases/model/scene.hpp"

// The scenes S1 to S6 on which engines are compared side by side, in time and in quality (docs/benchmarks.md).

namespace handhold::catalogue {

/// A box fixed to a body: what an engine without voxels is given of its shape. Frame B: origin at the box's centre.
struct SolidBox {
  Eigen::Vector3d half_extents{Eigen::Vector3d::Zero()};  ///< [m]
  Pose X_OB{};
};

/// A phalanx that takes part; all others of its hand are parked far away.
struct ActivePhalanx {
  int hand{}, phalanx{};
};

/// The object is gripped, lifted, held still, lifted again and shaken. Times in [s].
struct GripPlan {
  double overlap{0.003};                          ///< of every phalanx with the undisturbed object [m]
  double closed{0.5};                             ///< the fingers have closed
  double hold_begin{1.5}, hold_end{6.5};          ///< the hand is at rest
  double shake_begin{8}, shake_end{11};           ///< ±5 cm at 2 Hz, upright
  double lift_begin{6.5}, lift_end{7.5};          ///< 30 cm
  double pre_lift_begin{0.7}, pre_lift_end{1.2};  ///< 5 cm
};

/// Body 1 slides over body 0.
struct SlidePlan {
  Eigen::Vector3d direction_W{Eigen::Vector3d::UnitX()};  ///< unit
  double distance{};                                      ///< it must have come by `at`; 0: it must stay [m]
  double at{1};                                           ///< [s]
};

/// Bodies 1 and up stand on body 0.
struct TowerPlan {
  double settled{1};  ///< springs have found their balance by then [s]
  double until{10};   ///< nothing may have moved by then [s]
};

/// Body 0 hangs between two fingertips, its centre of mass level with the pivot at t = 0; angles from hanging.
struct SwingPlan {
  Eigen::Vector3d axis_W{Eigen::Vector3d::UnitX()};
  Eigen::Vector3d pivot_O{Eigen::Vector3d::Zero()}, pivot_W{Eigen::Vector3d::Zero()};
  double half_period{};    ///< of the swing without friction; 0: with friction [s]
  double turning_angle{};  ///< where it first comes to rest, with friction [rad]
};

struct BenchmarkScene {
  std::string id{};     ///< e.g. "S4a"
  std::string title{};  ///< e.g. "tower of 100 cubes hit by an axe"
  Scene scene{};
  std::vector<std::vector<SolidBox>> boxes{};  ///< of every body of the scene, in its frame O (centre of mass)
  std::vector<ActivePhalanx> phalanges{};      ///< empty where patches are given: only handhold can play those
  std::variant<GripPlan, SlidePlan, TowerPlan, SwingPlan> plan{};
};

/// "S1", "S2", "S3-24", ..., "S6b", in the order of the document.
[[nodiscard]] const std::vector<std::string>& benchmark_ids();

/// The scene of an id; throws InputError listing the ids for another.
[[nodiscard]] BenchmarkScene benchmark_scene(std::string_view id);

/// S2 with part of its phalanges, for cost against their number.
struct TwoHandGrip {
  int phalanges{32};  ///< even, 2 to 32; half of them on each side
  int samples{8};     ///< a patch
  double voxel{0};    ///< of the box [m]; 0: the default of the voxelizer
};

/// Throws InputError for a number of phalanges that is odd or out of range.
[[nodiscard]] BenchmarkScene two_hand_grip(const TwoHandGrip& options);

/// A tower of `wide` x `wide` columns of `high` cubes at rest, for cost against the number of bodies; throws InputError
/// for less than one cube or more than 250.
[[nodiscard]] BenchmarkScene tower(int wide, int high, double duration);

}  // namespace handhold::catalogue
