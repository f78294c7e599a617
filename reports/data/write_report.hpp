// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "compare/judge/suite.hpp"
#include "reports/data/stored_report.hpp"

namespace handhold::reports {

/// Throws InputError unless a report can be written to `folder`: its parent must be writable, and the folder must be
/// new, empty or an earlier report (it is replaced as a whole, so it must hold nothing else). Ask before a long run,
/// not after it.
void check_report_folder(const std::filesystem::path& folder);

/// Writes index.html, results.json, times.json, junit.xml, table.txt and recordings/ into a new folder beside `folder`,
/// then exchanges the two in one step and removes the old one: an interrupt or a full disk leaves the previous report
/// whole. Parents are made as needed. Throws InputError if it cannot be written.
void write_report(const compare::SuiteResult& result, const std::filesystem::path& folder);

/// The same of a report that was stored, without junit.xml and table.txt.
void write_stored_report(const StoredReport& report, const std::filesystem::path& folder);

/// Makes `folder` with its parents if need be; throws InputError unless files can then be written into it.
void make_writable_folder(const std::filesystem::path& folder);

/// Writes one file beside `path`, then renames it over `path`; the same promise for a single file. Throws InputError.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace handhold::reports
