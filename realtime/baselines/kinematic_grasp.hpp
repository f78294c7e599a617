// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "realtime/baselines/baseline.hpp"

namespace handhold::realtime::baselines {

struct KinematicGraspOptions {
  double stiffness{800};      ///< spring of a phalanx that measures its force from its depth [N/m], > 0
  double threshold{1};        ///< squeeze that grasps [N], > 0
  double release_share{0.3};  ///< of the threshold: a smaller squeeze lets go; 0 to 1
};

void validate(const KinematicGraspOptions& options);

/// The paper's first baseline, "our re-implementation of the kinematic part of [20]" (Kim & Park 2015): "the object is
/// considered as grasped when some measured forces reach a self defined threshold. Then the global transformation of
/// the hand is applied to the object which is set to kinematic."
///
/// The force measured is ours to choose: each phalanx pushes with stiffness times its depth along the surface's normal;
/// their squeeze is the part that cancels, (Σ|f| − |Σf|) / 2, so that pushing from one side alone grasps nothing. The
/// hand's transformation is its palm's.
class KinematicGrasp : public Baseline {
 public:
  explicit KinematicGrasp(const Scene& scene, const KinematicGraspOptions& options = {});

  /// Of a hand with these distances [N].
  [[nodiscard]] double squeeze(const Nearnesses& near) const;

 protected:
  [[nodiscard]] bool grasps(std::size_t, std::size_t, const HandFrame&, const Nearnesses& near) override {
    return squeeze(near) >= options_.threshold;
  }
  [[nodiscard]] bool releases(std::size_t, std::size_t, const HandFrame&, const Nearnesses& near) override {
    return squeeze(near) < options_.release_share * options_.threshold;
  }
  [[nodiscard]] Pose grip_frame(std::size_t, const HandFrame& frame) const override { return frame.X_WP[palm]; }

 private:
  KinematicGraspOptions options_;
};

}  // namespace handhold::realtime::baselines
