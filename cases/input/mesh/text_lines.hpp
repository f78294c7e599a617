// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace handhold {

/// What a line-based format has besides words.
struct LineRules {
  bool comments{};       ///< from '#' to the end of the line
  bool continuations{};  ///< a backslash at the end of a line joins the next one
};

/// Walks through the lines and words of a text file and reads its numbers; remembers where it is for messages.
///
/// The text is what `plain_text` gives; lines end with LF, CR LF or CR. A number is a decimal one in the notation of C,
/// with or without digits before its point; whatever else is in a word is refused.
class TextLines {
 public:
  TextLines(std::string_view text, std::string file, LineRules rules);

  /// Moves to the next line; false at the end of the text.
  bool next();
  /// Moves to the next line with a word on it and gives that word; throws at the end of the text.
  std::string_view first_word(const char* what);
  /// The next word of the line; empty at its end.
  std::string_view word();

  double real(std::string_view word) const;
  double real() { return real(word()); }
  long whole(std::string_view word) const;

  /// Throws InputError with file and line.
  [[noreturn]] void fail(const std::string& rule, const std::string& advice) const;

  [[nodiscard]] int number() const { return number_; }
  /// What follows the current line.
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  bool take_line();

  std::string_view rest_, line_;
  std::string file_;
  LineRules rules_;
  int number_ = 0;
  bool continued_ = false;  // the current line goes on in the next one
};

/// At most 20 characters of a word of a damaged file, what cannot be printed as '?'.
[[nodiscard]] std::string printable(std::string_view word);

/// The word with its ASCII letters in lower case.
[[nodiscard]] std::string lower(std::string_view word);

}  // namespace handhold
