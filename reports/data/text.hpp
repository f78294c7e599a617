// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace handhold::reports {

/// For XML and HTML, in text and in quoted attributes: cleaned (clean_text), and & < > " ' as entities.
[[nodiscard]] std::string escape(std::string_view text);

/// Code points: the width in a terminal of the letters and signs that we use.
[[nodiscard]] std::size_t width(std::string_view utf8);

/// Exactly `columns` wide: padded on the right, or cut with an ellipsis.
[[nodiscard]] std::string left(std::string_view utf8, std::size_t columns);

/// At least `columns` wide: padded on the left, never cut (a cut number is a wrong number).
[[nodiscard]] std::string right(std::string_view utf8, std::size_t columns);

/// Cleaned (clean_text); newlines and runs of blanks become one blank.
[[nodiscard]] std::string one_line(std::string_view text);

/// A line of a summary: two blanks, the name in a column, the value; a long value goes on below, broken at blanks.
[[nodiscard]] std::string summary_line(std::string_view name, std::string_view value);

/// "1.23457", "1.2e-05", "inf"; "none" for NaN, which is how a recording says that it does not show a value.
[[nodiscard]] std::string number(double value, int digits = 6);

/// An error or a limit: in percent when it is a fraction of the truth.
[[nodiscard]] std::string error_number(double value, bool relative, int digits = 2);

/// "0.983 ± 0.004": as many decimals as the standard error shows, two or three; below 0.0005 it is written "<0.001".
[[nodiscard]] std::string with_error(double value, double standard_error);

/// The signs of print: "−1.2×10⁻⁵" for "-1.2e-05".
[[nodiscard]] std::string typographic(std::string_view number);

/// Multiply by `factor` to get `unit`.
struct Scale {
  double factor{1};
  std::string unit{};
};

/// The prefix that brings `largest` between 1 and 1000: 3.2e-6 m is 3.2 µm. A unit that takes no prefix gets a power of
/// ten.
[[nodiscard]] Scale readable_scale(double largest, std::string_view unit);

/// "3.2 µm", "11.1 ms"
[[nodiscard]] std::string readable(double value, std::string_view unit, int digits = 3);

}  // namespace handhold::reports
