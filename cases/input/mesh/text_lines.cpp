// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/mesh/text_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"

namespace handhold {
namespace {

constexpr std::string_view blanks = " \t\v\f";

// "1.#QNAN", "1.#INF" and the like are how some compilers print what is not a finite number.
bool is_broken_number(std::string_view line, std::size_t hash) {
  const std::string rest = lower(line.substr(hash + 1, 4));
  return hash >= 2 && line.substr(hash - 2, 2) == "1." &&
         (rest == "qnan" || rest == "snan" || rest.substr(0, 3) == "inf" || rest.substr(0, 3) == "ind");
}

// Where the comment of a line begins.
std::size_t comment_start(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1)) {
    if (!is_broken_number(line, at)) return at;
  }
  return line.size();
}

// What from_chars reads knows no plus sign.
std::string_view without_plus(std::string_view text) {
  const bool plus = !text.empty() && text[0] == '+' && text.substr(1, 1) != "-";
  return text.substr(plus);
}

}  // namespace

TextLines::TextLines(std::string_view text, std::string file, LineRules rules)
    : rest_(text), file_(std::move(file)), rules_(rules) {
  if (text.substr(0, 4).find('\0') != std::string_view::npos)
    throw InputError(file_ + ": is UTF-32 text or no text at all (save it as UTF-8)");
}

bool TextLines::take_line() {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  line_ = rest_.substr(0, end);
  const bool two = rest_.substr(end, 2) == "\r\n";
  rest_.remove_prefix(std::min(rest_.size(), end + 1 + two));
  ++number_;
  const std::size_t comment = rules_.comments ? comment_start(line_) : line_.size();
  const bool commented = comment < line_.size();
  line_ = line_.substr(0, comment);
  const std::size_t last = line_.find_last_not_of(blanks);
  continued_ = rules_.continuations && !commented && last != std::string_view::npos && line_[last] == '\\';
  if (continued_) line_ = line_.substr(0, last);
  return true;
}

bool TextLines::next() {
  while (continued_ && take_line()) continue;
  return take_line();
}

std::string_view TextLines::word() {
  for (;;) {
    const std::size_t begin = line_.find_first_not_of(blanks);
    if (begin != std::string_view::npos) {
      const std::size_t end = std::min(line_.find_first_of(blanks, begin), line_.size());
      const std::string_view result = line_.substr(begin, end - begin);
      line_ = line_.substr(end);
      return result;
    }
    line_ = {};
    if (!continued_ || !take_line()) return {};
  }
}

std::string_view TextLines::first_word(const char* what) {
  while (next()) {
    if (const std::string_view found = word(); !found.empty()) return found;
  }
  fail(fmt::format("the file ends within {}", what), "is it truncated?");
}

double TextLines::real(std::string_view text) const {
  if (text.empty()) fail("a vertex needs three coordinates", "complete the line");
  const std::string_view digits = without_plus(text);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole_word = end == digits.data() + digits.size();
  // Too small for a double is as good as zero; too large is not.
  if (error == std::errc::result_out_of_range && whole_word) value = std::strtod(std::string(digits).c_str(), nullptr);
  if (error == std::errc::invalid_argument || !whole_word || !std::isfinite(value))
    fail(fmt::format("'{}' is not a finite number", printable(text)), "correct the coordinate");
  return value;
}

long TextLines::whole(std::string_view text) const {
  const std::string_view digits = without_plus(text);
  long value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size())
    fail(fmt::format("'{}' is not a whole number", printable(text)), "correct the line");
  return value;
}

void TextLines::fail(const std::string& rule, const std::string& advice) const {
  throw InputError(fmt::format("{}:{}: {} ({})", file_, number_, rule, advice));
}

std::string printable(std::string_view word) {
  std::string text(word.substr(0, 20));
  for (char& c : text) c = c < ' ' || c > '~' ? '?' : c;
  return text;
}

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

}  // namespace handhold
