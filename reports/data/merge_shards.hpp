// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "reports/data/stored_report.hpp"

namespace handhold::reports {

/// The report of a suite whose parts were played by several processes (SuiteOptions::shard): its results.json has the
/// bytes that one process would have written, whatever the order in which the parts are given. Times stand beside each
/// other. Throws InputError if a part is missing, there twice, interrupted, or of another suite.
[[nodiscard]] StoredReport merged_shards(std::vector<NamedReport> parts);

}  // namespace handhold::reports
