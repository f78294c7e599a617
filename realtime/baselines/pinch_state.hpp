// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "realtime/baselines/baseline.hpp"

namespace handhold::realtime::baselines {

struct PinchStateOptions {
  double grasp_distance{0.001};    ///< thumb and finger nearer than this to the body grasp it [m]
  double release_distance{0.006};  ///< either of them farther lets go [m], above grasp_distance
  double opposition{0.3};          ///< the normals below them must have −n·n at least this; −1 to 1
};

void validate(const PinchStateOptions& options);

/// The paper's second baseline in its manner: a kinematic grasp by states, as Leap Motion's Interaction Engine 1.0 has
/// it (its own rules are not published; these are ours). The last phalanges of thumb and one finger on opposite sides
/// of the body pinch it: it then follows the middle between the two tips with the palm's orientation, until one of them
/// is clear of the body by more than the hysteresis.
class PinchState : public Baseline {
 public:
  explicit PinchState(const Scene& scene, const PinchStateOptions& options = {});

 protected:
  [[nodiscard]] bool grasps(std::size_t body, std::size_t hand, const HandFrame& frame,
                            const Nearnesses& near) override;
  [[nodiscard]] bool releases(std::size_t body, std::size_t hand, const HandFrame& frame,
                              const Nearnesses& near) override;
  [[nodiscard]] Pose grip_frame(std::size_t body, const HandFrame& frame) const override;

 private:
  PinchStateOptions options_;
  std::vector<int> finger_;  // that opposes the thumb, of every held body
};

}  // namespace handhold::realtime::baselines
