// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace handhold::realtime::testing {

/// How many times this program has called operator new so far (allocations_test.cpp). realtime allocates by nothing
/// else: its objects know no malloc, and it has no Eigen type of dynamic size.
[[nodiscard]] std::size_t allocations();

}  // namespace handhold::realtime::testing
