// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include <fmt/format.h>

#include "compare/engine/engine.hpp"
#include "compare/engine/paper_player.hpp"
#include "compare/engine/stepped.hpp"

namespace handhold::compare {
namespace {

namespace paper = realtime::paper;

/// A hand may begin far away: anchors follow it once it is near [m].
constexpr double seed_reach = 10;

paper::Options law_of(const Scene& scene) {
  paper::Options law = printed::coulomb();
  law.stiffness = scene.contact.stiffness;
  law.damping = scene.contact.damping;
  return law;
}

std::vector<PlayedPatch> patches_of(const Scene& scene) {
  std::vector<PlayedPatch> patches;
  for (std::size_t h = 0; h < scene.hands.size(); ++h) {
    for (const GivenPatch& given : scene.hands[h].given) {
      const int phalanx = given.phalanx;
      patches.push_back({std::uint8_t(h), std::uint8_t(phalanx), given.p_P, given.start,
                         [motion = scene.hands[h].motion, phalanx](double t) { return motion->pose(phalanx, t); }});
    }
  }
  return patches;
}

Played played(const Scene& scene, const EngineOptions& options) {
  const Body& body = scene.bodies.front();
  std::vector<PlayedPatch> patches = patches_of(scene);
  paper::Middleware law(paper::make_surface(printed::Voxels{body.field}), body.inertia.center, body.friction,
                        law_of(scene), int(patches.size()));
  Played out{.host = {std::move(law),
                      host_body(body.inertia, body.mobility, body.X_WO, body.V_WO),
                      scene.gravity,
                      {.substeps = options.substeps}},
             .patches = std::move(patches),
             .load = body.load};
  seed(out, seed_reach);
  return out;
}

/// Frames by where they begin; the end of the last one is one more.
std::vector<PlayedFrame> played_frames(const Scene& scene, const EngineOptions& options) {
  std::vector<PlayedFrame> frames;
  double t = 0;
  for (const double end : frames_of(scene, options)) {
    frames.push_back({t, end - t});
    t = end;
  }
  frames.push_back({t, frames.back().dt});
  return frames;
}

/// The middleware with every switch at Coulomb's side, in front of its host: what the paper's architecture gives if its
/// law is put right. Springs and dampers are explicit, so that a stiff scene on a light body can blow up.
class PaperCoulombEngine : public Engine {
 public:
  [[nodiscard]] EngineInfo info(const EngineOptions& options) const override {
    return {.name = "paper-coulomb",
            .version = HANDHOLD_VERSION,
            .levels = {Level::compliant},
            .records = {.contacts = true, .events = true, .frame_times = true},
            .settings = {{"frame rate", fmt::format("{} Hz", options.frame_rate)},
                         {"sub-steps a frame", fmt::format("{}, anchors kept", options.substeps)},
                         {"law", "docs/paper.md, column Coulomb"},
                         {"surface", "triangles"},
                         {"integrator", "semi-implicit Euler"}}};
  }

  [[nodiscard]] std::string why_not(const Problem& problem) const override {
    const auto& scene = std::get<Scene>(problem);
    if (scene.bodies.size() != 1) return "its host moves one body only";
    if (scene.bodies.front().held_until > 0) return "its host has no support that holds a body until a hand is there";
    if (scene.hands.empty()) return "without a hand it has nothing to play";
    for (const Hand& hand : scene.hands)
      if (hand.given.empty()) return "it feels given sample points, not whole phalanges";
    for (const PlayedPatch& patch : patches_of(scene))
      if (patch.p_P.size() > std::size_t(max_samples))
        return fmt::format("its patches hold at most {} samples", max_samples);
    return {};
  }

  [[nodiscard]] Recording play(const Problem& problem, const EngineOptions& options,
                               const Progress& progress) const override {
    const auto& scene = std::get<Scene>(problem);
    validate(scene);
    const std::vector<PlayedFrame> frames = played_frames(scene, options);
    Played body = played(scene, options);
    Recording recording{.engine = "paper-coulomb",
                        .scene = scene.name,
                        .provenance = info(options).settings,
                        .body_names = {scene.bodies.front().name}};
    compare::play(body, frames, progress, recording);
    return recording;
  }
};

}  // namespace

std::unique_ptr<Engine> make_paper_coulomb_engine() { return std::make_unique<PaperCoulombEngine>(); }

}  // namespace handhold::compare
