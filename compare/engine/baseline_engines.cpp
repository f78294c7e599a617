// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include <fmt/format.h>

#include "compare/engine/engine.hpp"
#include "compare/engine/stepped.hpp"
#include "realtime/baselines/kinematic_grasp.hpp"
#include "realtime/baselines/pinch_state.hpp"

namespace handhold::compare {
namespace {

using realtime::baselines::Baseline;

Frame frame_of(const Baseline& baseline) {
  Frame frame{.t = baseline.time(), .contacts = baseline.contacts(), .energy = baseline.energy()};
  for (std::size_t b = 0; b < baseline.bodies(); ++b) frame.bodies.push_back(baseline.state(b));
  return frame;
}

/// An interaction model of the paper's study: it moves objects without forces, so its errors are graded.
template <class Model>
class BaselineEngine : public Engine {
 public:
  explicit BaselineEngine(std::string name) : name_(std::move(name)) {}

  [[nodiscard]] EngineInfo info(const EngineOptions& options) const override {
    return {.name = name_,
            .version = HANDHOLD_VERSION,
            .levels = {Level::compliant},
            .records = {.frame_times = true},
            .settings = {{"frame rate", fmt::format("{} Hz", options.frame_rate)}}};
  }

  [[nodiscard]] std::string why_not(const Problem& problem) const override {
    for (const Hand& hand : std::get<Scene>(problem).hands)
      if (!hand.given.empty()) return "it feels whole phalanges, not given sample points";
    return {};
  }

  [[nodiscard]] Recording play(const Problem& problem, const EngineOptions& options,
                               const Progress& progress) const override {
    const Scene& scene = std::get<Scene>(problem);
    validate(scene);
    (void)frames_of(scene, options);  // checks them
    Model baseline(scene);
    std::vector<HandFrame> hands(scene.hands.size());
    sample_hands(scene, 0, hands);
    baseline.start(1 / options.frame_rate, hands);
    Recording recording{.engine = name_, .scene = scene.name, .provenance = info(options).settings};
    stepwise(scene, options, progress, baseline, frame_of, recording);
    return recording;
  }

 private:
  std::string name_;
};

}  // namespace

std::unique_ptr<Engine> make_kinematic_grasp_engine() {
  return std::make_unique<BaselineEngine<realtime::baselines::KinematicGrasp>>("kinematic-grasp");
}

std::unique_ptr<Engine> make_pinch_state_engine() {
  return std::make_unique<BaselineEngine<realtime::baselines::PinchState>>("pinch-state");
}

}  // namespace handhold::compare
