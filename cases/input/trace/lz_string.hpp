// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handhold {

/// Text (UTF-8) that LZString's compressToBase64 packed, as in LeapJS recordings (`.json.lz`).
///
/// LZ78 over UTF-16 code units: a code of growing width is 0 or 1 (a new character of 8 or 16 bits follows), 2 (the
/// end) or a phrase seen before; every code adds the phrase "previous phrase + one character". White space around the
/// text is ignored. Throws InputError with `name` and the byte for foreign characters, a broken or unfinished stream,
/// and for more than 512 MiB of text.
[[nodiscard]] std::string decompress_lz_string(std::string_view base64, const std::string& name = "LZString text");

}  // namespace handhold
