// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "realtime/hand_path.hpp"
#include "tests/realtime/step_audit.hpp"

namespace handhold::realtime::testing {

/// A World with any number of sub-steps, whose every sub-step is audited: a twin with one sub-step a
/// frame takes the same steps, at the poses that HandPath gives, and must have the same bits at every frame.
class AuditedTwin {
 public:
  /// `before` are the frames ahead of t = 0, oldest first; the last one is that of t = 0. dt > 0 [s].
  AuditedTwin(const Scene& scene, const Options& options, double dt, const std::vector<std::vector<HandFrame>>& before)
      : substeps_(options.substeps),
        dt_(dt),
        world_(world_def_of(scene), options),
        twin_(world_def_of(scene), twin_options(options, dt)),
        paths_(scene.hands.size(), HandPath(options.longest_bridge)),
        steps_(scene.hands.size()),
        audit_(scene) {
    for (const auto& frame : before) {
      for (std::size_t i = 0; i < paths_.size(); ++i) paths_[i].observe(dt, frame[i]);
      if (&frame != &before.back()) world_.observe(dt, frame);
    }
    world_.start(dt, before.back());
    place(1);
    twin_.start(dt / substeps_, steps_);
    audit_.begin(twin_, steps_);
  }

  void advance(const std::vector<HandFrame>& frame) {
    world_.advance(dt_, frame);
    for (std::size_t i = 0; i < paths_.size(); ++i) paths_[i].observe(dt_, frame[i]);
    for (const World::Step& step : world_.steps()) {
      place(step.fraction);
      audit_.advance(twin_, step.h, steps_);
    }
  }

  /// The same bits in both.
  [[nodiscard]] bool agrees() const {
    for (std::size_t i = 0; i < world_.bodies().size(); ++i) {
      const RigidBody &a = world_.bodies()[i], &b = twin_.bodies()[i];
      if (a.X_WO.p != b.X_WO.p || a.X_WO.R.coeffs() != b.X_WO.R.coeffs() || a.v != b.v || a.w != b.w) return false;
    }
    return StepAudit::book(world_) == StepAudit::book(twin_);
  }

  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] const AuditTally& tally() const { return audit_.tally(); }

 private:
  /// The steps are the world's, none is cut again. A gap of m frames is over by (m + 1) dt for the world, for the twin
  /// by m dt and its next step, which is no longer than a sub-step.
  static Options twin_options(Options options, double dt) {
    const double most_frames = std::floor(options.longest_bridge / dt) - 1;
    options.longest_bridge = most_frames < 0 ? 0 : (most_frames + 1.0 / options.substeps) * dt * (1 + 1e-9);
    options.substeps = 1;
    options.longest_turn = std::numeric_limits<double>::infinity();
    return options;
  }
  void place(double fraction) {
    for (std::size_t hand = 0; hand < paths_.size(); ++hand) {
      steps_[hand].present = paths_[hand].present();
      if (!steps_[hand].present) continue;
      for (int i = 0; i < phalanx_count; ++i) steps_[hand].X_WP[std::size_t(i)] = paths_[hand].pose(i, fraction);
    }
  }

  int substeps_;
  double dt_;
  World world_, twin_;
  std::vector<HandPath> paths_;
  std::vector<HandFrame> steps_;
  StepAudit audit_;
};

}  // namespace handhold::realtime::testing
