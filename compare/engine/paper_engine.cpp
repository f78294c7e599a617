// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "compare/engine/engine.hpp"
#include "compare/engine/paper_player.hpp"

namespace handhold::compare {
namespace {

namespace paper = realtime::paper;

Played played(const PrintedProblem& p) {
  paper::Middleware law(paper::make_surface(p.shape), p.inertia.center, p.friction, p.law, int(p.phalanges.size()));
  Played out{.host = {std::move(law), host_body(p.inertia, p.mobility, p.X_WO, p.V_WO), p.gravity, p.host},
             .load = p.load};
  for (std::size_t i = 0; i < p.phalanges.size(); ++i) {
    const printed::Phalanx& phalanx = p.phalanges[i];
    out.patches.push_back({0, std::uint8_t(i), phalanx.p_P, phalanx.start, phalanx.pose});
  }
  seed(out, printed::seed_reach);
  return out;
}

/// The middleware in front of its own host, as printed. The frame belongs to the problem, so that no option has a say
/// and no error falls with a step: a claim's limit is the rounding of an exact map, or says itself what a frame does.
class PaperEngine : public Engine {
 public:
  [[nodiscard]] EngineInfo info(const EngineOptions&) const override {
    return {.name = "paper",
            .version = HANDHOLD_VERSION,
            .levels = {Level::printed},
            .errs = {.kind = ErrorModel::Kind::stepped},
            .records = {.contacts = true, .events = true, .frame_times = true},
            .settings = {{"frame, law and host", "the problem's"}}};
  }

  [[nodiscard]] Recording play(const Problem& given, const EngineOptions& options,
                               const Progress& progress) const override {
    const auto& problem = std::get<PrintedProblem>(given);
    validate(problem);
    Played body = played(problem);
    std::vector<PlayedFrame> frames;
    for (int k = 0; k <= problem.frames; ++k) frames.push_back({k * problem.frame, problem.frame});
    Recording recording{.engine = "paper", .provenance = info(options).settings, .body_names = {"body"}};
    compare::play(body, frames, progress, recording);
    return recording;
  }
};

}  // namespace

std::unique_ptr<Engine> make_paper_engine() { return std::make_unique<PaperEngine>(); }

}  // namespace handhold::compare
