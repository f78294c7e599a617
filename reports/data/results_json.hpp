// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "compare/judge/result.hpp"

namespace handhold::reports {

/// All that was judged as JSON, described by reports/data/results.schema.json. Keys stand in a fixed order, doubles
/// round-trip, and the same result gives the same bytes, whenever and with however many threads it was measured. JSON
/// has no NaN and no infinity: such a number is null, and a text beside it says which ("value": null, "value_text":
/// "nan"); in a list, "<list>_text" maps the place to the text.
[[nodiscard]] std::string results_json(const compare::SuiteResult& result);

/// The names that recordings are kept by, for the page.
using RecordingNames = std::map<const compare::Play*, std::string>;

/// What differs from one run to the next: when and where it ran, wall times, CPU times a frame, and the names of
/// recordings, which hold such times.
[[nodiscard]] std::string times_json(const compare::SuiteResult& result, const RecordingNames& recordings = {});

}  // namespace handhold::reports
