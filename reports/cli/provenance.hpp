#pragma once

#include <map>
#include <string>

#include "compare/judge/suite.hpp"

namespace handhold::reports {

/// What a reader needs to repeat a run: version, compiler and its flags, machine, options, and when.
[[nodiscard]] std::map<std::string, std::string> provenance(const compare::SuiteOptions& options);

}  // namespace handhold::reports
