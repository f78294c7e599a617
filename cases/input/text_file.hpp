// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace handhold {

/// The whole file (or pipe); throws InputError if it cannot be read, is a folder, or holds more than 512 MiB.
[[nodiscard]] std::string read_text_file(const std::string& path);

/// "grab" of "recordings/grab.json.lz".
[[nodiscard]] std::string stem_of(const std::string& path);

}  // namespace handhold
