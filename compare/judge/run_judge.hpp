// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "compare/judge/suite.hpp"

namespace handhold::compare {

/// Plays one run with every engine, and judges it. Shared by the threads of a suite.
class RunJudge {
 public:
  RunJudge(const std::vector<const Engine*>& engines, const SuiteOptions& options);

  [[nodiscard]] const std::vector<EngineInfo>& engines() const { return infos_; }

  /// Nothing if SuiteOptions::stop ended it.
  [[nodiscard]] std::optional<RunResult> judge(const catalogue::Run& run, Level level) const;

 private:
  std::vector<const Engine*> engines_;
  std::vector<EngineInfo> infos_;
  SuiteOptions options_;
};

}  // namespace handhold::compare
