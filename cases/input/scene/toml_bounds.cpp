// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/scene/toml_bounds.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr int deepest = 32;  // scenes need four

/// Behind the string that begins at `at`: of one line, or of several in three quotes.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool several = text.substr(at, 3) == three;
  std::size_t i = at + (several ? 3 : 1);
  for (; i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
      continue;
    }
    if (several ? text.substr(i, 3) == three : text[i] == quote || text[i] == '\n') break;
  }
  return std::min(text.size(), i + (several ? 3 : 1));
}

[[noreturn]] void fail(std::string_view text, std::size_t at, const std::string& source, const char* what) {
  const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
  throw InputError(fmt::format("{}:{}: {} (is it a scene?)", source, line, fmt::format(fmt::runtime(what), deepest)));
}

}  // namespace

void check_toml_bounds(std::string_view text, const std::string& source) {
  int depth = 0, dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '"' || c == '\'') {
      i = end_of_string(text, i);
      continue;
    }
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (c == '.') ++dots;
    if (c == '=' || c == ',' || c == '\n' || c == '[' || c == '{') dots = 0;
    if (depth > deepest) fail(text, i, source, "lists and tables are nested more than {} deep");
    if (dots >= deepest) fail(text, i, source, "a key has more than {} parts");
    ++i;
  }
}

}  // namespace handhold
