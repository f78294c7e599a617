// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handhold::reports {

/// Raw deflate (RFC 1951) at the highest level: what a browser's DecompressionStream('deflate-raw') reads. The same
/// bytes for the same input and version of zlib.
[[nodiscard]] std::string deflated(std::string_view bytes);

/// The bytes that `deflated` was given; throws InputError if `bytes` is no whole stream.
[[nodiscard]] std::string inflated(std::string_view bytes);

/// RFC 4648 with padding, on one line.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace handhold::reports
