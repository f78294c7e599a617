// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handhold {

/// The bytes start as a gzip file (RFC 1952).
[[nodiscard]] bool is_gzip(std::string_view bytes);

/// What a gzip file holds. Throws InputError that starts with `path` for a damaged or unfinished one, and for more than
/// `most` bytes of content.
[[nodiscard]] std::string gunzip(std::string_view bytes, std::size_t most, const std::string& path);

}  // namespace handhold
