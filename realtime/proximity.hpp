#pragma once

#include "cases/geometry/voxel_field.hpp"
#include "cases/hand/patch.hpp"

namespace handhold::realtime {

/// Watches one phalanx against one object. The exact distance costs tens of microseconds, so it is asked for only when
/// the phalanx could have moved far enough since the last time to change the verdict.
class Proximity {
 public:
  enum class Verdict {
    same,
    near,  ///< nearer than the offset: seed a patch at `place()`
    far,   ///< farther than twice the offset: drop the patch
  };

  explicit Proximity(const PhalanxShape& shape);

  /// `active`: the phalanx has a patch, so only `far` matters; else only `near`.
  [[nodiscard]] Verdict update(const VoxelField& field, const Pose& X_OP, bool active, double offset);

  [[nodiscard]] const Nearest& place() const { return place_; }  ///< of the last verdict `near`

 private:
  PhalanxShape shape_;
  double reach_{};   // of the shape from its centroid
  Pose X_OP_{};      // where it was asked for last
  Nearest place_{};  // and what the answer was
  bool known_{false};
};

}  // namespace handhold::realtime
