// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "cases/hand/trace.hpp"
#include "cases/model/pose.hpp"
#include "cases/model/voxel_field.hpp"

// Puts an object where a recorded hand closes: recordings of grasps without an object say nothing about where it was.

namespace handhold {

struct PlacementOptions {
  double depth{0.004};       ///< aimed at for thumb and finger at closure [m]
  double most_depth{0.008};  ///< deeper is avoided, of every phalanx but the palm [m]
  double palm_depth{0.002};  ///< deeper is avoided, of the palm [m]
  double hold{0.02};         ///< the support stays for this long after closure [s]
  double least_grip{0.2};    ///< shorter closings are no grasp [s]
  double lead{0.05};         ///< the scene starts this long before the first phalanx comes near [s]
  double mu_static{
      0.46};  ///< of the object against skin, for the grip's margin (Zhang & Mak 1999: the mean of materials)
};

/// Throws InputError unless 0 < depth <= most_depth, and all are finite and >= 0.
void validate(const PlacementOptions& options);

/// A phalanx inside the object at closure.
struct Touch {
  int phalanx{};
  double depth{};                                ///< of its skin [m]
  Eigen::Vector3d n_W{Eigen::Vector3d::Zero()};  ///< unit, outward normal of the object there
};

/// Where an object is put, and when it is let go. Times are the trace's.
struct Placement {
  Pose X_WO{};
  double start{};       ///< all phalanges are clear of the object, or least deep in it: t = 0 of the scene [s]
  double closure{};     ///< thumb and finger have closed on the object [s]
  double held_until{};  ///< the support lets go [s]: Body::held_until is this minus `start`
  double until{};       ///< the recorded grasp ends: the gap opens again, or the hand is lost [s]
  int finger{};         ///< that opposes the thumb, 1 to 4
  double thickness{};   ///< of the object between them [m]
  double opposition{};  ///< -n·n of the object's normals below thumb and finger: 1 is exactly opposite
  double excess{};      ///< deepest the grip would go beyond most_depth if the object did not yield, a side, mean [m]
  double margin{};      ///< of the grip at rest: friction allowed over friction needed (grip_strength.hpp)
  double load{1};       ///< largest |a - g| of the palm during the grasp, in units of g
  double cost{};        ///< by which placements are ranked: all that is unwanted, as metres of depth
  std::vector<Touch> touches{};  ///< at closure, by phalanx
  std::string note{};            ///< what is less than wished for; empty if nothing

  /// "closes at 2.41 s on 13.0 mm: thumb_distal 4.0 mm, index_distal 4.1 mm; opposition 0.98"
  [[nodiscard]] std::string report() const;
};

struct Placements {
  std::vector<Placement> ranked{};  ///< the best first, at least one, no two alike
  long poses{};                     ///< of the object that were looked at
};

/// The `count` best ways to put `field` into hand number `hand` of `trace`, as geometry and statics see it.
///
/// A closing is a stretch in which the gap between the tips of thumb and finger, once wide enough for the object, stays
/// smaller than the object less twice `depth` (or half, a quarter ... of it, on what is thin). Candidates are opposite
/// places of the surface (grasp_places.hpp), laid between the two tips at closure or a little nearer to the palm, in 24
/// orientations each, then moved along the line between them until both tips are as deep. Ranked by unwanted depth,
/// then and on the way in, thin rather than thick, near the centre of volume, no finger inside a cup, the margin of the
/// grip under gravity and the hand's acceleration, upright (z of O up) on ties. Deterministic. Throws InputError if the
/// hand never closes on any place of the object (it says how far it closes), or is present for more than an hour.
[[nodiscard]] Placements placements_in_hand(const Trace& trace, std::size_t hand, const VoxelField& field,
                                            std::size_t count, const PlacementOptions& options = {});

/// The first of them.
[[nodiscard]] Placement place_in_hand(const Trace& trace, std::size_t hand, const VoxelField& field,
                                      const PlacementOptions& options = {});

/// A pose given by hand: "x,y,z" [m] or "x,y,z,qw,qx,qy,qz" (norm 1 +- 1e-3), of O in W; throws InputError for anything
/// else.
[[nodiscard]] Pose parse_placement(std::string_view text);

}  // namespace handhold
