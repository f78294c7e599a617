// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "cases/model/hand_frame.hpp"
#include "cases/model/pose.hpp"

namespace handhold::realtime {

/// One hand between its last two frames, as a C1 path: cubic Hermite with velocities from backward differences of
/// second order (3 x0 − 4 x1 + x2) / (2 dt), so that no future frame is needed and a frame rate adds no jumps of
/// velocity. A straight line would jump by a dt at every frame, which rings every contact spring of a light object.
/// Fewer than three frames: first order, or rest.
class HandPath {
 public:
  /// `longest_bridge`: after a longer absence nothing is known of where the hand has been [s].
  explicit HandPath(double longest_bridge = 0.1) : longest_bridge_(longest_bridge) {}

  /// The next frame, `dt` seconds after the last. A hand that was absent starts anew, at rest; a pose that is not
  /// finite counts as absent.
  void observe(double dt, const HandFrame& frame);

  [[nodiscard]] bool present() const { return known_ > 0; }

  /// Pose of a phalanx at `fraction` of the way from the last frame but one (0) to the last (1).
  [[nodiscard]] Pose pose(int phalanx, double fraction) const;

  /// The hand is back after a gap that is short enough to know which way it came: straight from `last_seen`.
  [[nodiscard]] bool is_back() const { return is_back_; }
  [[nodiscard]] const Pose& last_seen(int phalanx) const { return seen(1).X_WP[std::size_t(phalanx)]; }

 private:
  struct Seen {
    double dt{};  // since the frame before
    std::array<Pose, phalanx_count> X_WP{};
  };
  /// A phalanx's step between two frames, the turn as a rotation vector in the earlier phalanx's frame; rates are per
  /// frame.
  struct Step {
    Eigen::Vector3d move{Eigen::Vector3d::Zero()}, turn{Eigen::Vector3d::Zero()};
    Eigen::Vector3d rate_begin{Eigen::Vector3d::Zero()}, rate_end{Eigen::Vector3d::Zero()};  // of move
    Eigen::Vector3d spin_begin{Eigen::Vector3d::Zero()}, spin_end{Eigen::Vector3d::Zero()};  // angular, in P
  };
  [[nodiscard]] const Seen& seen(int frames_ago) const { return seen_[std::size_t((newest_ - frames_ago) & 3)]; }
  [[nodiscard]] Eigen::Vector3d move(int phalanx, int frames_ago) const;
  [[nodiscard]] Eigen::Vector3d turn(int phalanx, int frames_ago) const;
  [[nodiscard]] Step step(int phalanx) const;

  double longest_bridge_;
  std::array<Seen, 4> seen_{};  // in turn
  int newest_{};
  int known_{};  // frames seen in a row, up to 4
  bool ever_{false}, is_back_{false};
  double absent_{};  // for how long [s]
};

}  // namespace handhold::realtime
