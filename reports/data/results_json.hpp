#pragma once

#include <string>

#include "compare/judge/suite.hpp"

namespace handhold::reports {

/// The whole result as JSON, described by reports/data/results.schema.json. Keys stand in a fixed order, doubles
/// round-trip, and the same result gives the same bytes. JSON has no NaN and no infinity: such a number is null, and a
/// text beside it says which
/// ("value": null, "value_text": "nan"); in a list, "<list>_text" maps the place to the text.
[[nodiscard]] std::string results_json(const compare::SuiteResult& result);

}  // namespace handhold::reports
