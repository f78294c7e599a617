// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "compare/judge/suite.hpp"

namespace handhold::reports {

/// The result as JUnit XML: a testsuite a case, a testcase a gate. The wall time of an engine's run is shared evenly
/// among its gates, so that sums are right; order studies carry none. An interrupted or empty run adds an error of its
/// own, so that no reader takes it for a pass.
[[nodiscard]] std::string junit_xml(const compare::SuiteResult& result);

}  // namespace handhold::reports
