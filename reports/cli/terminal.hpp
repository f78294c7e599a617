// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace handhold::reports {

/// Writes lines to standard output, cleaned (clean_text): names from files of others cannot command the terminal.
void say(std::string_view lines);

}  // namespace handhold::reports
