#include "compare/baseline_engines.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "cases/error.hpp"
#include "realtime/baselines/kinematic_grasp.hpp"
#include "realtime/baselines/pinch_state.hpp"

namespace handhold::compare {
namespace {

using realtime::HandFrame;
using realtime::baselines::Baseline;

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

void sample_hands(const Scene& scene, double t, std::vector<HandFrame>& hands) {
  for (std::size_t i = 0; i < hands.size(); ++i) {
    const HandMotion& motion = *scene.hands[i].motion;
    hands[i].present = motion.present(t);
    if (!hands[i].present) continue;
    for (int p = 0; p < phalanx_count; ++p) hands[i].X_WP[p] = motion.pose(p, t);
  }
}

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
    if (!(options.frame_rate > 0) || !std::isfinite(options.frame_rate))
      throw InputError(fmt::format("frame_rate={} Hz: must be finite and > 0 (90 is the default)", options.frame_rate));
    Recording recording{.engine = name_, .scene = scene.name};
    recording.provenance = {{"frame_rate", fmt::format("{} Hz", options.frame_rate)}};
    for (const Body& body : scene.bodies) recording.body_names.push_back(body.name);
    const std::unique_ptr<Baseline> baseline = make_(scene);
    std::vector<HandFrame> hands(scene.hands.size());
    sample_hands(scene, 0, hands);
    baseline->start(1 / options.frame_rate, hands);
    recording.frames.push_back(frame_of(*baseline));
    const long frames = std::lround(std::ceil(scene.duration * options.frame_rate - 1e-9));
    for (long k = 1; k <= frames; ++k) {
      const double t = std::min(double(k) / options.frame_rate, scene.duration);
      sample_hands(scene, t, hands);
      const double before = thread_seconds();
      baseline->advance(t - baseline->time(), hands);
      recording.frame_time.push_back(thread_seconds() - before);
      recording.frames.push_back(frame_of(*baseline));
      recording.events.insert(recording.events.end(), baseline->events().begin(), baseline->events().end());
      if (progress && !progress(t)) {
        recording.outcome = Outcome::interrupted;
        recording.note = fmt::format("stopped at t = {:.4g} s of {:.4g} s", t, scene.duration);
        break;
      }
    }
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
