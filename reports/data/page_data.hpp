// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "reports/data/stored_report.hpp"

namespace handhold::reports {

/// The report as one HTML file that fetches nothing: the frame (see page_frame) filled with results, times, recordings
/// and meshes. Without JavaScript it shows a table of verdicts. The same report gives the same bytes. Throws InputError
/// if the results are no results.json of version 2.
[[nodiscard]] std::string page(const StoredReport& report);

}  // namespace handhold::reports
