// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "compare/engine/engine.hpp"
#include "reference/reference.hpp"

namespace handhold::compare {
namespace {

class ReferenceEngine : public Engine {
 public:
  [[nodiscard]] EngineInfo info(const EngineOptions& options) const override {
    return {.name = "reference",
            .version = HANDHOLD_VERSION,
            .levels = {Level::compliant},
            .errs = {.kind = ErrorModel::Kind::controlled, .accuracy = options.accuracy},
            .records = {.contacts = true, .events = true, .energy = true},
            .settings = {
                {"accuracy", fmt::format("{}", options.accuracy)},
                {"longest step", fmt::format("{} s", options.max_step)},
                {"surface", options.exact_mesh ? "triangles" : "triangles; smooth bodies: spline of the voxel field"}}};
  }

  [[nodiscard]] Recording play(const Problem& problem, const EngineOptions& options,
                               const Progress& progress) const override {
    return reference::simulate(
        std::get<Scene>(problem),
        {.accuracy = options.accuracy,
         .max_step = options.max_step,
         .frame_rate = options.frame_rate,
         .surface = options.exact_mesh ? reference::SurfaceModel::mesh : reference::SurfaceModel::automatic,
         .frame_times = options.frame_times},
        progress);
  }
};

}  // namespace

std::unique_ptr<Engine> make_reference_engine() { return std::make_unique<ReferenceEngine>(); }

}  // namespace handhold::compare
