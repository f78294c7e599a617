#include "compare/engines.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

#include "cases/error.hpp"
#include "compare/baseline_engines.hpp"
#include "realtime/world.hpp"
#ifdef HANDHOLD_REFERENCE
#include "reference/reference.hpp"
#endif

namespace handhold::compare {
namespace {

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

void sample_hands(const Scene& scene, double t, std::vector<realtime::HandFrame>& hands) {
  for (std::size_t i = 0; i < hands.size(); ++i) {
    const HandMotion& motion = *scene.hands[i].motion;
    hands[i].present = motion.present(t);
    if (!hands[i].present) continue;
    for (int p = 0; p < phalanx_count; ++p) hands[i].X_WP[p] = motion.pose(p, t);
  }
}

Frame frame_of(const realtime::World& world) {
  Frame frame{.t = world.time(), .energy = world.energy()};
  for (const realtime::RigidBody& body : world.bodies()) frame.bodies.push_back(body.state());
  const realtime::Contacts& contacts = world.contacts();
  for (const realtime::PatchSlot& patch : contacts.patches) {
    if (!patch.active) continue;
    for (int i = 0; i < patch.count; ++i) {
      const bool idle = patch.of_body() && contacts.mode[patch.slot(i)] == Mode::apart;  // most of a body's samples
      if (!idle) frame.contacts.push_back(world.contact(patch.slot(i)));
    }
  }
  std::sort(frame.contacts.begin(), frame.contacts.end(),
            [](const ContactState& a, const ContactState& b) { return a.id < b.id; });
  return frame;
}

class RealtimeEngine : public Engine {
 public:
  [[nodiscard]] std::string name() const override { return "realtime"; }

  [[nodiscard]] Recording simulate(const Scene& scene, const EngineOptions& options,
                                   const Progress& progress) const override {
    validate(scene);
    if (!(options.frame_rate > 0) || !std::isfinite(options.frame_rate))
      throw InputError(fmt::format("frame_rate={} Hz: must be finite and > 0 (90 is the default)", options.frame_rate));
    Recording recording{.engine = name(), .scene = scene.name};
    recording.provenance = {{"frame_rate", fmt::format("{} Hz", options.frame_rate)},
                            {"substeps", fmt::format("{}", options.substeps)}};
    for (const Body& body : scene.bodies) recording.body_names.push_back(body.name);
    realtime::World world(scene, {.substeps = options.substeps});
    std::vector<realtime::HandFrame> hands(scene.hands.size());
    const double dt = 1 / options.frame_rate;
    for (const double before : {-2 * dt, -dt}) {
      sample_hands(scene, before, hands);
      world.observe(dt, hands);
    }
    sample_hands(scene, 0, hands);
    world.start(dt, hands);
    recording.frames.push_back(frame_of(world));
    const long frames = std::lround(std::ceil(scene.duration * options.frame_rate - 1e-9));
    for (long k = 1; k <= frames; ++k) {
      const double t = std::min(double(k) / options.frame_rate, scene.duration);
      sample_hands(scene, t, hands);
      const double before = thread_seconds();
      world.advance(t - world.time(), hands);
      recording.frame_time.push_back(thread_seconds() - before);
      recording.frames.push_back(frame_of(world));
      recording.events.insert(recording.events.end(), world.events().begin(), world.events().end());
      const std::vector<BodyState>& bodies = recording.frames.back().bodies;
      const auto lost =
          std::find_if(bodies.begin(), bodies.end(), [](const BodyState& body) { return !body.X_WO.p.allFinite(); });
      if (lost != bodies.end()) {
        recording.outcome = Outcome::diverged;
        const std::string& body = recording.body_names[std::size_t(lost - bodies.begin())];
        recording.note = fmt::format("body '{}' left the finite numbers at t = {:.4g} s", body, t);
        break;
      }
      if (progress && !progress(t)) {
        recording.outcome = Outcome::interrupted;
        recording.note = fmt::format("stopped at t = {:.4g} s of {:.4g} s", t, scene.duration);
        break;
      }
    }
    if (world.unconverged() > 0) recording.provenance["unconverged_substeps"] = fmt::format("{}", world.unconverged());
    return recording;
  }
};

#ifdef HANDHOLD_REFERENCE
class ReferenceEngine : public Engine {
 public:
  [[nodiscard]] std::string name() const override { return "reference"; }

  [[nodiscard]] Recording simulate(const Scene& scene, const EngineOptions& options,
                                   const Progress& progress) const override {
    return reference::simulate(
        scene, {.accuracy = options.accuracy, .max_step = options.max_step, .frame_rate = options.frame_rate},
        progress);
  }
};
#endif

}  // namespace

std::unique_ptr<Engine> make_engine(const std::string& name) {
  if (name == "realtime") return std::make_unique<RealtimeEngine>();
#ifdef HANDHOLD_REFERENCE
  if (name == "reference") return std::make_unique<ReferenceEngine>();
#endif
  if (std::unique_ptr<Engine> baseline = make_baseline_engine(name)) return baseline;
  std::string known;
  for (const std::string& engine : engine_names()) known += (known.empty() ? "" : ", ") + engine;
  throw InputError(fmt::format("engine '{}': no such engine (there are {})", name, known));
}

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
#ifdef HANDHOLD_REFERENCE
  names.emplace_back("reference");
#endif
  names.emplace_back("realtime");
  for (const std::string& name : baseline_engine_names()) names.push_back(name);
  return names;
}

}  // namespace handhold::compare
