// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "cases/model/friction.hpp"
#include "cases/model/patch.hpp"
#include "cases/model/pose.hpp"
#include "cases/model/recording.hpp"
#include "realtime/paper/law.hpp"
#include "realtime/paper/surface.hpp"

namespace handhold::realtime::paper {

/// Where a rigid body is and how it moves: what an engine hands over once a frame.
struct BodyMotion {
  Pose X_WO{};
  Eigen::Vector3d v{Eigen::Vector3d::Zero()};  ///< of the centre of mass, in W [m/s]
  Eigen::Vector3d w{Eigen::Vector3d::Zero()};  ///< in W [rad/s]
};

/// Force and torque on the body about its centre of mass, in W [N, N m].
struct Wrench {
  Eigen::Vector3d force{Eigen::Vector3d::Zero()};
  Eigen::Vector3d torque{Eigen::Vector3d::Zero()};
};

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Derivative of (force, torque), anchors and modes held: by a displacement of the centre of mass and a small rotation
/// about it (both in W), and by (v, w). For engines that are implicit in time.
struct WrenchSlopes {
  Matrix6 by_pose{Matrix6::Zero()};
  Matrix6 by_velocity{Matrix6::Zero()};
};

/// A contact sample as it stands after a frame.
struct SampleState {
  Mode mode{Mode::apart};
  Spot anchor{};
  Spot used{};                                   ///< the anchor that the frame's force used: eq. 1 holds with it
  Eigen::Vector3d p_P{Eigen::Vector3d::Zero()};  ///< on the phalanx, in P
  Eigen::Vector3d f_W{Eigen::Vector3d::Zero()};  ///< on the object at `used` [N]
};

/// The samples of one phalanx (or of anything that pushes).
struct PatchState {
  bool active{false};
  int count{};
  std::array<SampleState, max_samples> samples{};
  Pose X_WP{};        ///< in the last frame
  bool known{false};  ///< X_WP is: without it a damper knows no velocity
};

/// "Our approach acts as a middleware between the hand input and the physics engine" (section 3.5): phalanx poses and
/// the body's motion in, a wrench out, once a frame. It moves no body, knows no gravity and no engine.
///
/// Deterministic; nothing is allocated after construction. One object; use one middleware an object.
class Middleware {
 public:
  /// `center_O`: centre of mass in O. Room for `patches` patches. Throws InputError for options out of range.
  Middleware(std::shared_ptr<const Surface> surface, const Eigen::Vector3d& center_O, const Friction& friction,
             const Options& options, int patches);

  /// Makes a patch with these sample points (in P, at most max_samples), each anchored at the closest surface point
  /// within `reach` [m] of it; a sample without one stays out. Replaces what the patch held.
  void seed(int patch, const Pose& X_WP, const Pose& X_WO, std::span<const Eigen::Vector3d> p_P, double reach);

  /// Puts a sample's anchor and mode: a state given from outside.
  void set(int patch, int sample, const Spot& anchor, Mode mode);

  /// "Trigger" left: the patch is gone.
  void drop(int patch);

  /// One frame: forces by eq. 1 to 5, and the anchors of slipping samples. `X_WP` has one pose a patch; `dt` [s] since
  /// the last frame is asked for by the damper alone.
  const Wrench& frame(double dt, std::span<const Pose> X_WP, const BodyMotion& body);

  /// The wrench if the body were at `body` now: cone test and force anew, no anchor moves, nothing is remembered.
  [[nodiscard]] Wrench wrench_at(const BodyMotion& body) const;

  /// Derivatives of `wrench_at` there.
  [[nodiscard]] WrenchSlopes slopes_at(const BodyMotion& body) const;

  [[nodiscard]] const Wrench& wrench() const { return wrench_; }  ///< of the last frame
  [[nodiscard]] const std::vector<PatchState>& patches() const { return patches_; }
  [[nodiscard]] const Options& options() const { return options_; }
  [[nodiscard]] const Surface& surface() const { return *surface_; }

 private:
  [[nodiscard]] Eigen::Vector3d point(const PatchState& patch, int i, const Pose& X_WP) const;
  [[nodiscard]] Sample sample_of(const PatchState& patch, int i, const BodyMotion& body) const;
  void step(PatchState& patch, int i, const BodyMotion& body, const Pose& X_OW);
  void move_anchor(SampleState& sample, const Eigen::Vector3d& p_O, Mode mode) const;

  std::shared_ptr<const Surface> surface_;
  Eigen::Vector3d center_O_;
  Friction friction_;
  Options options_;
  std::vector<PatchState> patches_;
  std::vector<std::array<Eigen::Vector3d, max_samples>> v_p_;  // velocities of the points, for the damper
  Wrench wrench_{};
};

}  // namespace handhold::realtime::paper
