#include "compare/engine/engines.hpp"

#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "compare/engine/baseline_engines.hpp"
#include "compare/engine/stepped.hpp"
#include "realtime/world.hpp"
#ifdef HANDHOLD_REFERENCE
#include "reference/reference.hpp"
#endif

namespace handhold::compare {
namespace {

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
    (void)frames_of(scene, options);  // checks them
    realtime::World world(scene, {.substeps = options.substeps, .order = options.order});
    std::vector<HandFrame> hands(scene.hands.size());
    const double dt = 1 / options.frame_rate;
    for (const double before : {-2 * dt, -dt}) {
      sample_hands(scene, before, hands);
      world.observe(dt, hands);
    }
    sample_hands(scene, 0, hands);
    world.start(dt, hands);
    Recording recording{.engine = name(), .scene = scene.name};
    recording.provenance = {{"frame_rate", fmt::format("{} Hz", options.frame_rate)},
                            {"substeps", fmt::format("{}", options.substeps)},
                            {"order", fmt::format("{}", options.order)}};
    play(scene, options, progress, world, frame_of, recording);
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
        scene,
        {.accuracy = options.accuracy,
         .max_step = options.max_step,
         .frame_rate = options.frame_rate,
         .surface = options.exact_mesh ? reference::SurfaceModel::mesh : reference::SurfaceModel::voxels,
         .frame_times = options.frame_times},
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
