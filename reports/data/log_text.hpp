// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/log/log_replay.hpp"

namespace handhold::reports {

/// A judged log: what was found, each grip with what the law of friction makes of it, and the frames.
struct JudgedLog {
  std::string name{};
  std::vector<std::string> warnings{};
  compare::LogReport report{};
  std::vector<std::optional<compare::LogReplay>> replays{};  ///< one a grip, or empty: not replayed
  std::vector<double> mu_static{};                           ///< of each grip's object, as replayed
  std::string engine{};                                      ///< that replayed
};

/// For the terminal.
[[nodiscard]] std::string log_text(const JudgedLog& log);

/// The same as JSON: {"format": "handhold log verdict", "version": 1, "findings": [...], "grips": [...], "frames": {}}.
[[nodiscard]] std::string log_json(const JudgedLog& log);

}  // namespace handhold::reports
