// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cases/hand/grasp_places.hpp"
#include "cases/hand/grip.hpp"
#include "cases/hand/placement.hpp"

namespace handhold {

/// One way to put an object into a hand: a place of its surface, the closing that takes it, and its pose then.
struct PlacementCandidate {
  GraspPlace place{};
  Closing closing{};
  double depth{};   ///< aimed at for thumb and finger as the closing begins [m]
  double excess{};  ///< a side, beyond PlacementOptions::most_depth if the object did not yield [m]
  double margin{};  ///< of the grip, the least of three times of the closing (grip_strength.hpp)
  double load{};    ///< largest |a - g| of the palm at those times, in units of g
  double cost{};    ///< as metres of unwanted depth
  Pose X_WO{};
};

struct PlacementSearch {
  std::vector<PlacementCandidate> best{};  ///< ascending in cost, no two alike
  long poses{};                            ///< of the object that were looked at
  double narrowest{};                      ///< least gap between thumb and any finger [m]
  double thinnest{};                       ///< of the object's places; 0: it has none that fingers reach round [m]
};

/// Looks at opposite places of the surface (grasp_places.hpp) x closings x 24 orientations x 3 offsets towards the
/// palm, and ranks them by what geometry and statics say. Deterministic. Throws InputError if the hand is present for
/// more than an hour.
[[nodiscard]] PlacementSearch search_placements(const HandMotion& motion, const VoxelField& field,
                                                const PlacementOptions& options, std::size_t count);

}  // namespace handhold
