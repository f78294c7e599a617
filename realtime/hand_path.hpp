#pragma once

#include <array>

#include "cases/hand/hand_model.hpp"
#include "cases/pose.hpp"

namespace handhold::realtime {

/// One hand at one frame: all that the real-time path ever sees of it.
struct HandFrame {
  bool present{false};
  std::array<Pose, phalanx_count> X_WP{};
};

/// One hand between its last two frames, as a C1 path: cubic Hermite with velocities from backward differences of
/// second order (3 x0 − 4 x1 + x2) / (2 dt), so that no future frame is needed and a frame rate adds no jumps of
/// velocity. A straight line would jump by a dt at every frame, which rings every contact spring of a light object.
/// Fewer than three frames: first order, or rest.
class HandPath {
 public:
  /// The next frame, `dt` seconds after the last. A hand that was absent starts anew; a pose that is not finite counts
  /// as absent.
  void observe(double dt, const HandFrame& frame);

  [[nodiscard]] bool present() const { return known_ > 0; }

  /// Pose of a phalanx at `fraction` of the way from the last frame but one (0) to the last (1).
  [[nodiscard]] Pose pose(int phalanx, double fraction) const;

 private:
  /// A phalanx's step between two frames, the turn as a rotation vector in the earlier phalanx's frame; rates are per
  /// frame.
  struct Step {
    Eigen::Vector3d move{Eigen::Vector3d::Zero()}, turn{Eigen::Vector3d::Zero()};
    Eigen::Vector3d rate_begin{Eigen::Vector3d::Zero()}, rate_end{Eigen::Vector3d::Zero()};  // of move
    Eigen::Vector3d spin_begin{Eigen::Vector3d::Zero()}, spin_end{Eigen::Vector3d::Zero()};  // angular, in P
  };
  std::array<Pose, phalanx_count> begin_{}, end_{};
  std::array<Step, phalanx_count> step_{};
  double dt_{};
  int known_{};  // frames seen in a row, up to 3
};

}  // namespace handhold::realtime
