// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace handhold {

/// The name of `names` with the least edit distance (Levenshtein) to `given`, the first on ties; empty if there is none
/// nearer than half of the longer word: for "did you mean".
[[nodiscard]] std::string nearest_name(std::string_view given, const std::vector<std::string>& names);

/// "a, b, c".
[[nodiscard]] std::string join_names(const std::vector<std::string>& names);

}  // namespace handhold
