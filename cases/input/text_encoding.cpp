// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/text_encoding.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

namespace handhold {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

void append_utf8(std::string& out, std::uint32_t c) {
  const auto put = [&out](std::uint32_t byte) { out.push_back(static_cast<char>(byte)); };
  if (c < 0x80) return put(c);
  if (c < 0x800) return put(0xC0 | c >> 6), put(0x80 | (c & 0x3F));
  if (c < 0x10000) return put(0xE0 | c >> 12), put(0x80 | (c >> 6 & 0x3F)), put(0x80 | (c & 0x3F));
  put(0xF0 | c >> 18), put(0x80 | (c >> 12 & 0x3F)), put(0x80 | (c >> 6 & 0x3F)), put(0x80 | (c & 0x3F));
}

std::string from_utf16(std::string_view bytes, bool big_endian) {
  std::u16string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto a = static_cast<unsigned char>(bytes[i]), b = static_cast<unsigned char>(bytes[i + 1]);
    text.push_back(static_cast<char16_t>(big_endian ? a << 8 | b : b << 8 | a));
  }
  return to_utf8(text);
}

/// Length of the sequence at the start of `text`; 0 when it is not valid UTF-8 (overlong, surrogate, cut short, too
/// large).
std::size_t sequence_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xC2 && lead < 0xE0   ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || text.size() < length) return 0;
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  if (!std::all_of(text.begin() + 1, text.begin() + static_cast<long>(length), continues)) return 0;
  const auto second = static_cast<unsigned char>(text[1]);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool beyond = (lead == 0xED && second >= 0xA0) || (lead == 0xF4 && second >= 0x90);
  return overlong || beyond ? 0 : length;
}

/// Of a valid sequence of up to three bytes; what is longer is neither control nor mark.
std::uint32_t code_point(std::string_view sequence) {
  const auto bits = [&](std::size_t i) { return static_cast<unsigned char>(sequence[i]) & 0x3FU; };
  if (sequence.size() == 2) return (static_cast<unsigned char>(sequence[0]) & 0x1FU) << 6 | bits(1);
  if (sequence.size() == 3) return (static_cast<unsigned char>(sequence[0]) & 0x0FU) << 12 | bits(1) << 6 | bits(2);
  return sequence.size() == 1 ? static_cast<unsigned char>(sequence[0]) : 0x10000;
}

bool is_shown(std::uint32_t c) {
  if (c < 0x20) return c == '\t' || c == '\n' || c == '\r';
  const bool control = c >= 0x7F && c < 0xA0;
  const bool direction =
      c == 0x061C || c == 0x200E || c == 0x200F || (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
  return !control && !direction && c != 0xFFFE && c != 0xFFFF && c != 0xFEFF;
}

}  // namespace

std::string to_utf8(std::u16string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::uint32_t c = text[i];
    const bool pair = c >= 0xD800 && c < 0xDC00 && i + 1 < text.size() && text[i + 1] >= 0xDC00 && text[i + 1] < 0xE000;
    append_utf8(out, pair ? 0x10000 + ((c - 0xD800) << 10) + (text[++i] - 0xDC00u) : c);
  }
  return out;
}

std::string plain_text(std::string bytes) {
  const std::string_view text = bytes;
  const std::string_view start = text.substr(0, 2);
  if (text.substr(0, 3) == "\xEF\xBB\xBF") return bytes.substr(3);
  if (start == "\xFF\xFE") return from_utf16(text.substr(2), false);
  if (start == "\xFE\xFF") return from_utf16(text.substr(2), true);
  if (text.size() >= 4 && text[0] != 0 && text[1] == 0 && text[2] != 0 && text[3] == 0) return from_utf16(text, false);
  if (text.size() >= 4 && text[0] == 0 && text[1] != 0 && text[2] == 0 && text[3] != 0) return from_utf16(text, true);
  return bytes;
}

std::string clean_text(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    const bool good = length > 0 && is_shown(code_point(text.substr(0, length)));
    out += good ? text.substr(0, length) : replacement;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

std::string escape_hidden(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  while (!json.empty()) {
    const std::size_t length = std::max<std::size_t>(sequence_length(json), 1);
    const std::uint32_t c = code_point(json.substr(0, length));
    if (is_shown(c))
      out += json.substr(0, length);
    else
      out += fmt::format("\\u{:04x}", c);
    json.remove_prefix(length);
  }
  return out;
}

}  // namespace handhold
