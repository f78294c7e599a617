#pragma once

#include <string>

#include "compare/judge/suite.hpp"

namespace handhold::reports {

/// The result as one HTML page without JavaScript and without anything to fetch. Every text of the result is escaped;
/// the same result gives the same bytes. In order: verdict, provenance and the command to rerun, gates (failed first),
/// frame times, cases.
[[nodiscard]] std::string page(const compare::SuiteResult& result);

}  // namespace handhold::reports
