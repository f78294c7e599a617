// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handhold {

/// UTF-8 of UTF-16; a surrogate without its partner is written as it is.
[[nodiscard]] std::string to_utf8(std::u16string_view text);

/// The bytes of a text file as UTF-8 without byte order mark: UTF-16 of either byte order is known by its mark, or by
/// the zero in its first character, and converted. Other bytes stay as they are.
[[nodiscard]] std::string plain_text(std::string bytes);

/// `text` with U+FFFD for every byte that is not valid UTF-8, every control character but tab, line feed and carriage
/// return (C0, delete and C1), what reorders or hides text (bidirectional marks, U+2028 and U+2029), U+FFFE and U+FFFF:
/// for terminals, XML and HTML.
[[nodiscard]] std::string clean_text(std::string_view text);

/// JSON text with \\uXXXX for what `clean_text` would replace but JSON allows to stand in a string: the same value.
[[nodiscard]] std::string escape_hidden(std::string_view json);

}  // namespace handhold
