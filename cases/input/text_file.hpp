// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace handhold {

/// The whole file as UTF-8 without byte order mark, unpacked if it is gzip. Throws InputError if it cannot be read, is
/// no regular file (a device would never end, a pipe wait for ever), is damaged, or holds more than 512 MiB.
[[nodiscard]] std::string read_text_file(const std::string& path);

/// Clean text (text_encoding.hpp): "grab" of "recordings/grab.json.lz".
[[nodiscard]] std::string stem_of(const std::string& path);

}  // namespace handhold
