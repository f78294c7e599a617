// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "compare/judge/result.hpp"
#include "reports/data/packed_columns.hpp"

namespace handhold::reports {

/// What the page is made of, as it lies in a report's folder.
struct StoredReport {
  std::string results{};  ///< results.json
  std::string times{};    ///< times.json; may be empty
  Blobs recordings{};     ///< the files of recordings/, by name
};

/// A report and a short name for it, e.g. its folder's.
struct NamedReport {
  std::string name{};
  StoredReport report{};
};

/// Packs the recordings that the suite kept of scenes (SuiteOptions::keep_recordings).
[[nodiscard]] StoredReport stored_report(const compare::SuiteResult& result);

/// Reads a report's folder, or one results.json with what lies beside it. Throws InputError if there is none.
[[nodiscard]] StoredReport read_report(const std::filesystem::path& place);

/// The same, named after its folder.
[[nodiscard]] NamedReport read_named_report(const std::filesystem::path& place);

}  // namespace handhold::reports
