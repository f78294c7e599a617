// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include <Eigen/Core>

#include "cases/model/hand_model.hpp"
#include "cases/model/pose.hpp"
#include "cases/model/voxel_field.hpp"

namespace handhold::realtime {

/// Which phalanges freeze together.
enum class FreezeMode {
  whole_hand,  ///< "we freeze the hand mesh and update its rigid position by ... the virtual object" (section 3.4)
  per_finger,  ///< "we selectively freeze fingers being in contact": the others, and the palm, follow the tracker
};

struct VisualOptions {
  FreezeMode mode{FreezeMode::whole_hand};
  double refine_time{0.08};   ///< time constant of the blend to a refined pose [s], > 0
  double release_time{0.15};  ///< time constant of the blend back to the tracked pose [s], > 0
  double refine_most{0.02};   ///< a refinement moves a phalanx by at most this [m], >= 0
  double linger{0.04};        ///< a contact that is gone for less than this is no release [s], >= 0
};

/// Throws InputError for the first number out of its range.
void validate(const VisualOptions& options);

/// What a phalanx touches, as the contact engine says it.
struct PhalanxTouch {
  int body{-1};    ///< index of the body it touches, -1: none
  double depth{};  ///< of its skin in that body, < 0 outside [m]
};

/// One frame of one hand: where the tracker has it, what it touches, where the bodies are.
struct VisualInput {
  bool present{false};
  std::array<Pose, phalanx_count> X_WP{};
  std::array<PhalanxTouch, phalanx_count> touch{};
};

/// The hand that is drawn (Höll et al. 2018, section 3.4): from the moment of touch it stands still on the object,
/// though the tracked hand goes on into it; further fingers that touch refine it; after the last contact it glides
/// back.
///
/// * At touch the pose is taken where the skin met the surface, between this frame and the last (linear in the depth),
///   so that a fast hand is not frozen a frame's motion too deep.
/// * Blends are C1: the difference to the target starts with its value and rate and dies out as a critically damped
///   spring with ω = 2 / time constant, e(t) = (e0 + (e0' + ω e0) t) exp(−ω t), exact for any dt.
/// * Depth: a pose that stands still is as deep as it was at touch: 0 but for the curvature of one frame's path. A
/// blend
///   passes between two such poses, so it is at most half as deep as they are apart; keep_out() bounds that, too.
///
/// Depends on its input and its own state only; allocates nothing.
class VisualHand {
 public:
  explicit VisualHand(const VisualOptions& options = {});

  /// One frame, `dt` seconds after the last; `X_WO` has the bodies that `touch` names. A hand that is not present
  /// forgets everything.
  const std::array<Pose, phalanx_count>& advance(double dt, const VisualInput& input, std::span<const Pose> X_WO);

  [[nodiscard]] const std::array<Pose, phalanx_count>& poses() const { return drawn_; }
  /// Opaque in the paper, Fig. 7: it stands on an object.
  [[nodiscard]] bool frozen(int phalanx) const { return state_[std::size_t(phalanx)].body >= 0; }
  /// Not yet where its target is, by more than 0.1 mm.
  [[nodiscard]] bool blending(int phalanx) const;

 private:
  /// What a drawn phalanx is off its target, in W: translation, and rotation vector (drawn = exp(turn) target).
  struct Offset {
    Eigen::Vector3d move{Eigen::Vector3d::Zero()}, turn{Eigen::Vector3d::Zero()};
    Eigen::Vector3d move_rate{Eigen::Vector3d::Zero()}, turn_rate{Eigen::Vector3d::Zero()};
    double omega{1};
  };
  struct State {
    int body{-1};  // it stands on; -1: follows the tracker
    Pose X_OP{};   // where on it
    Offset offset{};
  };
  [[nodiscard]] static Offset difference(const Pose& drawn, const Pose& target);
  [[nodiscard]] Pose target(int phalanx, const VisualInput& input, std::span<const Pose> X_WO) const;
  [[nodiscard]] Pose caught(int phalanx, int body, double fraction, const VisualInput& input,
                            std::span<const Pose> X_WO) const;
  [[nodiscard]] double fraction(int phalanx, const PhalanxTouch& touch) const;
  void update_group(int first, int count, double dt, const VisualInput& input, std::span<const Pose> X_WO);
  void freeze(int first, int count, const VisualInput& input, std::span<const Pose> X_WO);
  void refine(int first, int count, const VisualInput& input, std::span<const Pose> X_WO);
  void release(int phalanx, double dt, const VisualInput& input, std::span<const Pose> X_WO);

  VisualOptions options_;
  std::array<State, phalanx_count> state_{};
  std::array<Pose, phalanx_count> drawn_{};
  std::array<double, phalanx_count> untouched_{};  // how long the phalanx's group has touched nothing [s]
  VisualInput last_{};
  static constexpr std::size_t most_bodies = 255;  // as many as a scene may have
  std::array<Pose, most_bodies> last_X_WO_{};
  std::size_t last_bodies_{};
};

/// Moves every phalanx of `poses` that is deeper than `bound` [m] in the object out along the surface's normal, 32
/// times at most: the drawn hand's depth is then bounded by `bound` wherever the object is thicker than the hand is
/// deep, and has no groove that is too narrow for the phalanx. Costs one exact distance for each phalanx near the
/// object.
void keep_out(const HandModel& model, const VoxelField& field, const Pose& X_WO, double bound,
              std::array<Pose, phalanx_count>& poses);

}  // namespace handhold::realtime
