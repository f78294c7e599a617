// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handhold {

/// Throws InputError with `source` and line for TOML that is nested deeper than scenes are: keys of more than 32 parts
/// (a.b.c) or lists and tables in one another. The parser follows both by recursion and would use up the stack.
void check_toml_bounds(std::string_view text, const std::string& source);

}  // namespace handhold
