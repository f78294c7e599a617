// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace handhold {

/// All bytes of a regular file. Never waits: a pipe, device or folder is refused before anything is read from it.
/// Throws InputError if it is missing, no regular file, unreadable, or larger than 512 MiB.
[[nodiscard]] std::string read_regular_file(const std::filesystem::path& file);

}  // namespace handhold
