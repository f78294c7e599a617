// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cases/catalogue/case.hpp"
#include "compare/judge/baseline.hpp"
#include "compare/judge/judgement.hpp"
#include "compare/measure/timing.hpp"
#include "compare/study/order_study.hpp"

namespace handhold::compare {

/// A claim and what every engine of the suite has to say to it, in the order of SuiteResult::engines.
struct ClaimResult {
  catalogue::Claim claim{};
  std::vector<Judgement> judgements{};
  std::vector<OrderStudy> studies{};  ///< of engines with a step, where the claim converges
};

/// What became of one engine in one run.
struct Play {
  std::string engine{};
  std::string why_not{};  ///< not asked, and why
  std::string note{};     ///< how it ended, when not complete
  double seconds{};       ///< wall time
  FrameTimes frame{};
  std::shared_ptr<const Recording> recording{};  ///< only where SuiteOptions::keep_recordings asks for it
};

/// A run's curve at the frames, for plots: the truth, and what each engine that played shows.
struct CurveData {
  std::string label{};
  std::vector<double> t{}, truth{};
  std::vector<std::pair<std::string, std::vector<double>>> engines{};
};

struct RunResult {
  std::string name{};
  std::string variant{};
  std::vector<ClaimResult> claims{};
  CurveData curve{};  ///< empty if the run has none
  std::vector<Play> plays{};
  std::shared_ptr<const Problem> problem{};  ///< only beside kept recordings
};

struct CaseResult {
  std::string id{}, title{}, statement{}, formula{}, note{}, truth_level{};
  Level level{};
  std::vector<RunResult> runs{};
};

/// Every `of`-th run of a suite, beginning with number `index` (from 1): a part that one of several processes plays.
struct Shard {
  std::size_t index{1}, of{1};
};

struct SuiteResult {
  std::vector<EngineInfo> engines{};
  std::vector<CaseResult> cases{};
  std::map<std::string, std::string> provenance{};  ///< versions, compiler, options: what the numbers hang on
  std::map<std::string, std::string> occasion{};    ///< when, where and how it was run: what they do not hang on
  double seconds{};
  bool interrupted{false};
  std::optional<Shard> shard{};                ///< what of the suite this is; none: all
  std::size_t runs{};                          ///< of the whole suite
  std::optional<std::vector<Change>> moved{};  ///< since the baseline; none: compared with none
};

}  // namespace handhold::compare
