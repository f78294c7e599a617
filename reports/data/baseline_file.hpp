// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/judge/baseline.hpp"

namespace handhold::reports {

/// A baseline as it is stored: JSON, a claim a line, and why it was written anew each time.
struct BaselineFile {
  compare::Baseline gates{};
  std::vector<std::string> reasons{};  ///< the newest last
};

/// The gates of a results.json. Throws InputError if `text` is none; `name` is for its message.
[[nodiscard]] compare::Baseline baseline_of(const std::string& results, const std::string& name);

/// Throws InputError if `path` is no baseline.
[[nodiscard]] BaselineFile read_baseline(const std::filesystem::path& path);

[[nodiscard]] std::string to_json(const BaselineFile& file);

}  // namespace handhold::reports
