// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cases/input/log/object_log.hpp"
#include "cases/model/hand_motion.hpp"
#include "cases/model/mass_properties.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold::compare {

/// A logged object with its solid.
struct LoggedSolid {
  std::string name{};
  std::shared_ptr<const VoxelField> field{};
  SolidProperties solid{};
};

/// How near the hands are to the object at one stamp.
struct Nearness {
  double depth{};  ///< of the deepest phalanx, < 0 outside, at least minus the field's band; no hand: -infinity [m]
  int hand{-1};    ///< number in the trace of the hand with that phalanx; -1: no hand
  int phalanx{};   ///< of it
  unsigned touching{};  ///< bit i: phalanx i of that hand is deeper than minus `touch_distance`
};

/// Two pieces that touch in an application are apart by its collision margin and the skin's thickness, and tracked
/// hands err by as much [m].
inline constexpr double touch_distance = 0.002;
/// Farther from every phalanx than this, no force of a hand reaches the object [m].
inline constexpr double away_distance = 0.005;

/// An object's motion and the hands beside it, at the stamps at which it was logged.
struct ObjectTrack {
  std::string name{};
  std::vector<double> t{};                ///< [s]
  std::vector<Eigen::Vector3d> center{};  ///< of its volume, in W [m]
  std::vector<Pose> X_WO{};
  std::vector<Nearness> near{};
};

/// The hands of a log as functions of time; empty without any.
using LoggedHands = std::vector<std::shared_ptr<const HandMotion>>;
[[nodiscard]] LoggedHands hands_of(const ObjectLog& log);

/// One track an object of the log, in its order; `solids` likewise.
[[nodiscard]] std::vector<ObjectTrack> tracks_of(const ObjectLog& log, const std::vector<LoggedSolid>& solids);

}  // namespace handhold::compare
