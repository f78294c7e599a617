// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "cases/model/patch.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold::realtime {

/// Watches one phalanx against one object. The exact distance costs tens of microseconds, so it is asked for only when
/// the phalanx could have moved far enough since the last time to change the verdict.
class Proximity {
 public:
  explicit Proximity(const PhalanxShape& shape);

  /// Where a phalanx that moves from X_OP to Y_OP, straight, first comes nearer than `offset`: the pose to seed a patch
  /// at, whose nearest place is `place()`; nothing if it does not. Sub-divides the way by what the distance allows
  /// (conservative advancement), so nothing is jumped over.
  [[nodiscard]] std::optional<Pose> approach(const VoxelField& field, const Pose& X_OP, const Pose& Y_OP,
                                             double offset);

  /// Farther than `limit`.
  [[nodiscard]] bool leaves(const VoxelField& field, const Pose& X_OP, double limit);

  [[nodiscard]] const Nearest& place() const { return place_; }  ///< of the last pose asked for
  [[nodiscard]] double reach() const { return reach_; }  ///< no point of the shape is farther from its centroid [m]

 private:
  /// No point of the shape moves farther from pose to pose.
  [[nodiscard]] double motion(const Pose& X, const Pose& Y) const;
  double measure(const VoxelField& field, const Pose& X_OP);

  PhalanxShape shape_;
  double reach_{};
  Pose X_OP_{};      // where it was asked for last
  Nearest place_{};  // and what the answer was
  bool known_{false};
};

}  // namespace handhold::realtime
