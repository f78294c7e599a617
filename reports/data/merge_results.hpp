// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reports/data/stored_report.hpp"

namespace handhold::reports {

/// One report of several: parts of one suite, or runs to be put side by side. Cases, runs and claims that have the same
/// name in both are one, with the judgements of both. An engine that played a case in an earlier report already is
/// another engine here, "<engine> (<name>)". Counts add up; it passes if all pass. Throws InputError if there is none
/// or one holds no results.json of version 2.
[[nodiscard]] StoredReport merged(std::vector<NamedReport> parts);

}  // namespace handhold::reports
