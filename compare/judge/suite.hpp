#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cases/catalogue/case.hpp"
#include "compare/engine/engine.hpp"
#include "compare/judge/gate.hpp"
#include "compare/measure/timing.hpp"
#include "compare/study/convergence.hpp"

namespace handhold::compare {

/// One expectation of a run, judged for one engine.
struct Judgement {
  double value{};  ///< measured; NaN when the recording does not show it
  double error{};  ///< |value − truth|, or |value / truth − 1| when the limit is relative
  Gate gate{};
  bool asked{true};  ///< false: the engine was not run (Run::not_realtime); the gate then says why and is not counted
};

/// Error of one quantity against the sub-step of the real-time path. The frame is shortened with the sub-step: a hand
/// is known at frames only, so refining the sub-step alone converges to the motion of a hand that moves between frames
/// as HandPath says.
struct OrderStudy {
  std::vector<double> substep{};  ///< [s], descending
  std::vector<double> error{};    ///< in the quantity's unit
  Order order{};
  Gate gate{};  ///< |order − 1| within its limit
};

struct Finding {
  catalogue::Expectation expectation{};
  Judgement reference{};
  Judgement realtime{};
  std::optional<OrderStudy> study{};
};

/// Samples of a run's curve at the recorded frames, for plots.
struct CurveData {
  std::string label{};
  std::vector<double> t{}, truth{}, reference{}, realtime{};
};

struct RunResult {
  std::string name{};
  std::vector<Finding> findings{};
  CurveData curve{};  ///< empty if the run has none
  FrameTimes realtime_frame{};
  double reference_seconds{}, realtime_seconds{};  ///< wall time of the whole runs
  std::string reference_note{}, realtime_note{};   ///< how a run ended, when not complete
};

struct CaseResult {
  std::string id{}, title{}, level{}, statement{}, formula{}, note{};
  std::vector<RunResult> runs{};
};

struct SuiteResult {
  std::vector<CaseResult> cases{};
  std::map<std::string, std::string> provenance{};  ///< versions, compiler, options, command line
  double seconds{};
  bool interrupted{false};
};

struct SuiteOptions {
  EngineOptions engine{};
  std::vector<std::string> ids{};                   ///< cases to run; empty: all
  std::vector<int> study_refinements{2, 4, 8, 16};  ///< of frame and sub-step in the order studies; empty: none
  std::function<bool()> stop{};  ///< asked now and then within a run; true ends the suite, without that run
};

/// Told what is about to run; returning false stops before it.
using SuiteProgress = std::function<bool(const std::string& what)>;

/// Runs every case through both engines and judges. Throws InputError for an unknown id (listing the ids).
[[nodiscard]] SuiteResult run_suite(const Engine& reference, const Engine& realtime, const SuiteOptions& options = {},
                                    const SuiteProgress& progress = {});

/// All gates of the result, in order: reference, real time (where it was asked) and order study of every finding.
[[nodiscard]] std::vector<const Gate*> gates(const SuiteResult& result);

/// True when every gate holds, there is at least one, and the run was not interrupted.
[[nodiscard]] bool passed(const SuiteResult& result);

}  // namespace handhold::compare
