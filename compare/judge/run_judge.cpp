// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/judge/run_judge.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "cases/model/defect.hpp"
#include "compare/measure/measure.hpp"

namespace handhold::compare {
namespace {

using catalogue::Claim;
using catalogue::Run;

std::string note_of(const Recording& recording) {
  if (recording.outcome == Outcome::complete) return recording.note;
  return fmt::format("{}: {}", to_string(recording.outcome), recording.note);
}

/// Thrown through a run that is to stop; never leaves this file.
struct Stopped {};

/// One run and what is known of it while the engines play it, one after the other.
class Playing {
 public:
  Playing(const Run& run, Level level, const SuiteOptions& options)
      : run_(run), level_(level), options_(options), problem_(std::make_shared<const Problem>(run.problem())) {
    result_.name = run.name;
    result_.variant = run.variant;
    for (const Claim& claim : run.claims) result_.claims.push_back({claim, {}, {}});
  }

  void play(const Engine& engine, const EngineInfo& info) {
    Play play{.engine = info.name, .why_not = why_not(engine, info)};
    if (!play.why_not.empty()) {
      for (ClaimResult& claim : result_.claims) claim.judgements.push_back(not_asked(info, play.why_not));
    } else {
      const auto start = std::chrono::steady_clock::now();
      const auto recording = std::make_shared<const Recording>(simulate(engine, options_.engine));
      play.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      play.note = note_of(*recording);
      play.frame = frame_times(recording->frame_time);
      judge(info, *recording);
      if (run_.curve) add_curve(info, *recording);
      study(engine, info);
      if (options_.keep_recordings) play.recording = recording;
    }
    result_.plays.push_back(std::move(play));
  }

  RunResult finish() {
    if (options_.keep_recordings) result_.problem = problem_;
    return std::move(result_);
  }

 private:
  [[nodiscard]] std::string why_not(const Engine& engine, const EngineInfo& info) const {
    if (std::ranges::find(info.levels, level_) == info.levels.end())
      return fmt::format("it does not play {}", to_string(level_));
    if (info.errs.kind == ErrorModel::Kind::stepped && !run_.not_stepped.empty()) return run_.not_stepped;
    return engine.why_not(*problem_);
  }

  /// Passes the wish to stop on to the engine. What it had until then is no recording of the run.
  [[nodiscard]] Recording simulate(const Engine& engine, const EngineOptions& options) const {
    bool stopped = false;
    Recording recording =
        engine.play(*problem_, options, [&](double) { return !(stopped = options_.stop && options_.stop()); });
    if (stopped || (options_.stop && options_.stop())) throw Stopped{};
    return recording;
  }

  void judge(const EngineInfo& info, const Recording& recording) {
    for (ClaimResult& claim : result_.claims) {
      const std::string why = why_not_asked(claim.claim, info);
      claim.judgements.push_back(
          why.empty() ? compare::judge(claim.claim, info, measure(*problem_, recording, claim.claim.measure))
                      : not_asked(info, why));
    }
  }

  /// The curve at the frames of the first engine that plays.
  void add_curve(const EngineInfo& info, const Recording& recording) {
    CurveData& data = result_.curve;
    catalogue::Measure what = run_.curve->measure;
    data.label = run_.curve->label;
    if (data.t.empty()) {
      for (const Frame& frame : recording.frames) {
        data.t.push_back(frame.t);
        data.truth.push_back(run_.curve->truth(frame.t));
      }
    }
    std::vector<double> values;
    for (const double t : data.t) {
      what.at = t;
      values.push_back(measure(*problem_, recording, what));
    }
    data.engines.emplace_back(info.name, std::move(values));
  }

  /// Error of every converging claim against the step, all from the same runs.
  void study(const Engine& engine, const EngineInfo& info) {
    const bool wanted = std::ranges::any_of(run_.claims, [](const Claim& claim) { return claim.converges; });
    if (DEFECT(studies_skipped, !wanted, true) || info.errs.kind != ErrorModel::Kind::stepped ||
        options_.study_refinements.size() < 3)
      return;
    std::vector<OrderStudy> studies(result_.claims.size(), OrderStudy{.engine = info.name});
    for (const int refinement : options_.study_refinements) {
      EngineOptions finer = options_.engine;
      finer.frame_rate *= refinement;
      const Recording recording = simulate(engine, finer);
      for (std::size_t i = 0; i < studies.size(); ++i) {
        const Claim& claim = result_.claims[i].claim;
        if (!claim.converges) continue;
        studies[i].step.push_back(engine.info(finer).errs.step);
        studies[i].error.push_back(std::abs(measure(*problem_, recording, claim.measure) - claim.truth));
      }
    }
    for (std::size_t i = 0; i < studies.size(); ++i) {
      if (!result_.claims[i].claim.converges) continue;
      conclude(studies[i], result_.claims[i].claim);
      result_.claims[i].studies.push_back(std::move(studies[i]));
    }
  }

  const Run& run_;
  Level level_;
  const SuiteOptions& options_;
  std::shared_ptr<const Problem> problem_;
  RunResult result_{};
};

}  // namespace

RunJudge::RunJudge(const std::vector<const Engine*>& engines, const SuiteOptions& options)
    : engines_(engines), options_(options) {
  for (const Engine* engine : engines) infos_.push_back(engine->info(options.engine));
}

std::optional<RunResult> RunJudge::judge(const Run& run, Level level) const {
  try {
    Playing playing(run, level, options_);
    for (std::size_t i = 0; i < engines_.size(); ++i) playing.play(*engines_[i], infos_[i]);
    return playing.finish();
  } catch (const Stopped&) {
    return {};
  }
}

}  // namespace handhold::compare
