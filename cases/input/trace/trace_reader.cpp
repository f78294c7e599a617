// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/trace/trace_reader.hpp"

#include <string_view>

#include <fmt/format.h>

#include "cases/input/text_file.hpp"
#include "cases/input/trace/joints_reader.hpp"
#include "cases/input/trace/leap_reader.hpp"
#include "cases/input/trace/lz_string.hpp"
#include "cases/input/trace/trace_csv.hpp"
#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// A packed recording is nothing but base64, thousands of characters of it.
bool is_base64(std::string_view text) {
  constexpr std::size_t least = 64;
  return text.size() >= least && text.find_first_not_of(
                                     "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                     "0123456789+/= \t\r\n") == std::string_view::npos;
}

/// JSON of joints names its format before its frames or after them: look for the member, not for its place.
bool has_format(std::string_view text) { return text.find("\"format\"") != std::string_view::npos; }

Trace read_json(std::string_view text, const std::string& path) {
  return has_format(text) ? read_joints(text, path) : read_leap(text, path);
}

}  // namespace

Trace read_trace(const std::string& path) {
  const std::string text = read_text_file(path);
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");  // white space or a byte order mark
  if (first == std::string::npos) throw InputError(fmt::format("{}: the file is empty (record a hand)", path));
  if (text[first] == '{') return read_json(std::string_view(text).substr(first), path);
  if (text[first] == '#') return read_trace_csv(std::string_view(text).substr(first), path);
  if (is_base64(text) || ends_with(path, ".lz")) return read_json(decompress_lz_string(text, path), path);
  throw InputError(
      fmt::format("{}: this format is unknown (use handhold's trace CSV, LeapJS .json or .json.lz, or OpenXR or "
                  "WebXR joints as JSON)",
                  path));
}

}  // namespace handhold
