// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "compare/judge/suite.hpp"

namespace handhold::reports {

/// What the numbers hang on: version, compiler, options. Engines say their own settings.
[[nodiscard]] std::map<std::string, std::string> provenance(const compare::SuiteOptions& options);

/// What they do not hang on: the machine, when, and the command.
[[nodiscard]] std::map<std::string, std::string> occasion(const std::string& command_line);

}  // namespace handhold::reports
