// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "cases/model/hand_model.hpp"
#include "cases/model/patch.hpp"
#include "realtime/hand_path.hpp"
#include "realtime/paper/middleware.hpp"

namespace handhold::realtime::paper {

/// The paper's method on whole hands: patches come where a phalanx is nearer than the contact offset, go where it is
/// farther than twice that (a trigger's exit with hysteresis), and Middleware does the rest.
///
/// A patch is 8 samples on a ring, wider on thumb and palm (section 3.2: cases/model/patch.hpp). Allocates nothing
/// after construction. Hands that are not present drop their patches.
class HandContact {
 public:
  /// `hands` models, `PatchOptions::contact_offset` and `reference_point` are taken from `options`.
  HandContact(std::shared_ptr<const VoxelField> field, Normals normals, const Eigen::Vector3d& center_O,
              const Friction& friction, const Options& options, std::vector<HandModel> hands,
              const PatchOptions& patch = {});

  /// One frame of `dt` [s]; `hands` has one frame a model. Poses that are not finite count as absent.
  const Wrench& frame(double dt, std::span<const HandFrame> hands, const BodyMotion& body);

  [[nodiscard]] const Middleware& middleware() const { return middleware_; }
  [[nodiscard]] std::size_t hands() const { return models_.size(); }
  /// Patch of a phalanx in `middleware().patches()`.
  [[nodiscard]] static int patch_of(int hand, int phalanx) { return hand * phalanx_count + phalanx; }

 private:
  void detect(int hand, int phalanx, const Pose& X_WP, const Pose& X_WO);

  std::shared_ptr<const VoxelField> field_;
  std::vector<HandModel> models_;
  PatchOptions patch_;
  Middleware middleware_;
  std::vector<Pose> X_WP_;  // one a patch
};

}  // namespace handhold::realtime::paper
