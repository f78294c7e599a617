#include "compare/engine/baseline_engines.hpp"

#include <functional>
#include <utility>

#include <fmt/format.h>

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

class BaselineEngine : public Engine {
 public:
  using Make = std::function<std::unique_ptr<Baseline>(const Scene&)>;
  BaselineEngine(std::string name, Make make) : name_(std::move(name)), make_(std::move(make)) {}
  [[nodiscard]] std::string name() const override { return name_; }

  [[nodiscard]] Recording simulate(const Scene& scene, const EngineOptions& options,
                                   const Progress& progress) const override {
    validate(scene);
    (void)frames_of(scene, options);  // checks them
    const std::unique_ptr<Baseline> baseline = make_(scene);
    std::vector<HandFrame> hands(scene.hands.size());
    sample_hands(scene, 0, hands);
    baseline->start(1 / options.frame_rate, hands);
    Recording recording{.engine = name_, .scene = scene.name};
    recording.provenance = {{"frame_rate", fmt::format("{} Hz", options.frame_rate)}};
    play(scene, options, progress, *baseline, frame_of, recording);
    return recording;
  }

 private:
  std::string name_;
  Make make_;
};

template <class T>
std::unique_ptr<Engine> engine_of(const std::string& name) {
  return std::make_unique<BaselineEngine>(name, [](const Scene& scene) { return std::make_unique<T>(scene); });
}

}  // namespace

std::vector<std::string> baseline_engine_names() { return {"kinematic-grasp", "pinch-state"}; }

std::unique_ptr<Engine> make_baseline_engine(const std::string& name) {
  if (name == "kinematic-grasp") return engine_of<realtime::baselines::KinematicGrasp>(name);
  if (name == "pinch-state") return engine_of<realtime::baselines::PinchState>(name);
  return nullptr;
}

}  // namespace handhold::compare
