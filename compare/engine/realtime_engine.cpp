// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "cases/model/defect.hpp"
#include "compare/engine/engines.hpp"
#include "compare/engine/stepped.hpp"
#include "realtime/world.hpp"

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
  [[nodiscard]] EngineInfo info(const EngineOptions& options) const override {
    return {.name = "realtime",
            .version = HANDHOLD_VERSION,
            .levels = {Level::compliant},
            .errs = {.kind = ErrorModel::Kind::stepped,
                     .step = 1 / (options.frame_rate * DEFECT(limit_of_the_frame, options.substeps, 1))},
            .records = {.contacts = true, .events = true, .energy = true, .frame_times = true},
            .settings = {{"frame rate", fmt::format("{} Hz", options.frame_rate)},
                         {"sub-steps a frame", fmt::format("{}", options.substeps)},
                         {"order", fmt::format("{}", options.order)}}};
  }

  [[nodiscard]] Recording play(const Problem& problem, const EngineOptions& options,
                               const Progress& progress) const override {
    const Scene& scene = std::get<Scene>(problem);
    validate(scene);
    (void)frames_of(scene, options);  // checks them
    realtime::World world(realtime::world_def_of(scene), {.substeps = options.substeps, .order = options.order});
    std::vector<HandFrame> hands(scene.hands.size());
    const double dt = 1 / options.frame_rate;
    for (const double before : {-2 * dt, -dt}) {
      sample_hands(scene, before, hands);
      world.observe(dt, hands);
    }
    sample_hands(scene, 0, hands);
    world.start(dt, hands);
    Recording recording{.engine = "realtime", .scene = scene.name, .provenance = info(options).settings};
    stepwise(scene, options, progress, world, frame_of, recording);
    if (world.unconverged() > 0) recording.provenance["unconverged_substeps"] = fmt::format("{}", world.unconverged());
    return recording;
  }
};

}  // namespace

std::unique_ptr<Engine> make_realtime_engine() { return std::make_unique<RealtimeEngine>(); }

}  // namespace handhold::compare
