#include "compare/judge/suite.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/model/input_error.hpp"
#include "compare/measure/measure.hpp"

namespace handhold::compare {
namespace {

using catalogue::Case;
using catalogue::Expectation;
using catalogue::Limit;
using catalogue::Measure;
using catalogue::Run;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Judgement judge(const Expectation& expectation, const Limit& limit, double limit_value, double value,
                const std::string& who) {
  Judgement j{.value = value};
  j.error = limit.relative ? std::abs(value / expectation.truth - 1) : std::abs(value - expectation.truth);
  j.gate = {.quantity = fmt::format("{} error, {}", expectation.quantity, who),
            .measured = j.error,
            .bound = Bound::at_most,
            .limit = limit_value,
            .unit = limit.relative ? "" : expectation.unit,
            .pedigree = expectation.pedigree,
            .reason = limit.reason,
            .resolution = limit.resolution};
  return j;
}

Judgement not_asked(const Expectation& e, const std::string& why) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  return {.value = nothing,
          .error = nothing,
          .gate = {.quantity = fmt::format("{}, real time", e.quantity), .unit = e.unit, .reason = "not asked: " + why},
          .asked = false};
}

std::string note_of(const Recording& recording) {
  if (recording.outcome == Outcome::complete) return recording.note;
  return fmt::format("{}: {}", to_string(recording.outcome), recording.note);
}

struct TimedRecording {
  Recording recording{};
  double seconds{};
};

/// Thrown through a run that is to stop; never leaves this file.
struct Stopped {};

/// Passes the wish to stop on to the engine. What it had until then is no recording of the run.
Recording simulate(const Engine& engine, const Scene& scene, const EngineOptions& options, const SuiteOptions& suite) {
  bool stopped = false;
  const Progress progress = [&](double) { return !(stopped = suite.stop && suite.stop()); };
  Recording recording = engine.simulate(scene, options, progress);
  if (stopped) throw Stopped{};
  return recording;
}

TimedRecording timed(const Engine& engine, const Scene& scene, const SuiteOptions& suite) {
  const auto start = std::chrono::steady_clock::now();
  TimedRecording out{simulate(engine, scene, suite.engine, suite), 0};
  out.seconds = seconds_since(start);
  return out;
}

/// The curve at every frame that both recordings have.
CurveData curve_data(const Scene& scene, const catalogue::Curve& curve, const Recording& reference,
                     const Recording& realtime) {
  CurveData data{.label = curve.label};
  Measure what = curve.measure;
  for (const Frame& frame : realtime.frames) {
    what.at = frame.t;
    data.t.push_back(frame.t);
    data.truth.push_back(curve.truth(frame.t));
    data.reference.push_back(measure(scene, reference, what));
    data.realtime.push_back(measure(scene, realtime, what));
  }
  return data;
}

/// First order is claimed wherever nothing switches; 0.1 is the band that the claim is tested to.
constexpr double order_band = 0.1;

/// Error of every converging quantity against the sub-step, all from the same runs.
void study_orders(const Engine& realtime, const Scene& scene, const SuiteOptions& options, RunResult& result) {
  const bool wanted = std::ranges::any_of(result.findings, [](const Finding& f) { return f.expectation.converges; });
  if (!wanted || options.study_refinements.size() < 3) return;
  for (Finding& finding : result.findings)
    if (finding.expectation.converges) finding.study.emplace();
  for (const int refinement : options.study_refinements) {
    EngineOptions finer = options.engine;
    finer.frame_rate *= refinement;
    const Recording recording = simulate(realtime, scene, finer, options);
    for (Finding& finding : result.findings) {
      if (!finding.study) continue;
      finding.study->substep.push_back(1 / (finer.frame_rate * finer.substeps));
      finding.study->error.push_back(
          std::abs(measure(scene, recording, finding.expectation.measure) - finding.expectation.truth));
    }
  }
  for (Finding& finding : result.findings) {
    if (!finding.study) continue;
    OrderStudy& study = *finding.study;
    study.order = observed_order(study.substep, study.error);
    study.gate = {.quantity = fmt::format("{}, |order − 1| of the real-time path", finding.expectation.quantity),
                  .measured = std::abs(study.order.slope - 1),
                  .limit = order_band,
                  .pedigree = finding.expectation.pedigree,
                  .reason = "a fully implicit first-order step: halving it halves the error",
                  .resolution = 0.01};
  }
}

RunResult run_one(const Run& run, const Engine& reference, const Engine& realtime, const SuiteOptions& options) {
  const Scene scene = run.scene();
  RunResult result{.name = run.name};
  const bool both = run.not_realtime.empty();
  const TimedRecording slow = timed(reference, scene, options);
  const TimedRecording fast = both ? timed(realtime, scene, options) : TimedRecording{};
  result.reference_seconds = slow.seconds;
  result.realtime_seconds = fast.seconds;
  result.reference_note = note_of(slow.recording);
  result.realtime_note = both ? note_of(fast.recording) : "not asked: " + run.not_realtime;
  result.realtime_frame = frame_times(fast.recording.frame_time);
  const double substep = 1 / (options.engine.frame_rate * options.engine.substeps);
  for (const Expectation& e : run.expectations) {
    Finding finding{.expectation = e};
    finding.reference =
        judge(e, e.reference, limit_for(e.reference, 0), measure(scene, slow.recording, e.measure), "reference");
    finding.realtime = both ? judge(e, e.realtime, limit_for(e.realtime, substep),
                                    measure(scene, fast.recording, e.measure), "real time")
                            : not_asked(e, run.not_realtime);
    result.findings.push_back(std::move(finding));
  }
  if (run.curve) result.curve = curve_data(scene, *run.curve, slow.recording, fast.recording);
  if (both) study_orders(realtime, scene, options, result);
  return result;
}

std::vector<const Case*> chosen(const std::vector<std::string>& ids) {
  std::vector<const Case*> cases;
  const auto& all = catalogue::all_cases();
  for (const std::string& id : ids)
    if (std::ranges::none_of(all, [&](const Case& c) { return c.id == id; })) {
      std::vector<std::string> known;
      known.reserve(all.size());
      for (const Case& c : all) known.push_back(c.id);
      throw InputError(fmt::format("case '{}': no such case (there are {})", id, fmt::join(known, ", ")));
    }
  for (const Case& c : all)
    if (ids.empty() || std::ranges::find(ids, c.id) != ids.end()) cases.push_back(&c);
  return cases;
}

}  // namespace

SuiteResult run_suite(const Engine& reference, const Engine& realtime, const SuiteOptions& options,
                      const SuiteProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  SuiteResult result;
  for (const Case* c : chosen(options.ids)) {
    CaseResult judged{c->id, c->title, c->level, c->statement, c->formula, c->note, {}};
    for (const Run& run : c->runs) {
      if (progress && !progress(fmt::format("{} {}", c->id, run.name))) {
        result.interrupted = true;
        break;
      }
      try {
        judged.runs.push_back(run_one(run, reference, realtime, options));
      } catch (const Stopped&) {
        result.interrupted = true;
        break;
      }
    }
    result.cases.push_back(std::move(judged));
    if (result.interrupted) break;
  }
  result.seconds = seconds_since(start);
  return result;
}

std::vector<const Gate*> gates(const SuiteResult& result) {
  std::vector<const Gate*> all;
  for (const CaseResult& c : result.cases)
    for (const RunResult& run : c.runs)
      for (const Finding& finding : run.findings) {
        all.push_back(&finding.reference.gate);
        if (finding.realtime.asked) all.push_back(&finding.realtime.gate);
        if (finding.study) all.push_back(&finding.study->gate);
      }
  return all;
}

bool passed(const SuiteResult& result) {
  const auto all = gates(result);
  return !result.interrupted && !all.empty() &&
         std::ranges::all_of(all, [](const Gate* gate) { return passes(*gate); });
}

}  // namespace handhold::compare
