// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/data/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "cases/input/text_encoding.hpp"

namespace handhold::reports {
namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

std::string superscript(std::string_view exponent) {
  static constexpr std::array<std::string_view, 10> digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out;
  bool leading = true;
  for (const char c : exponent) {
    if (c == '-') out += "⁻";
    if (c < '0' || c > '9' || (leading && c == '0')) continue;
    leading = false;
    out += digits[static_cast<std::size_t>(c - '0')];
  }
  return out;
}

std::string power_of_ten(int exponent) { return "10" + superscript(std::to_string(exponent)); }

bool takes_prefix(std::string_view unit) {
  static constexpr std::array<std::string_view, 8> units{"m", "s", "rad", "N", "J", "m/s", "rad/s", "W"};
  return std::find(units.begin(), units.end(), unit) != units.end();
}

}  // namespace

std::string escape(std::string_view text) {
  std::string out;
  for (const char c : clean_text(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::size_t width(std::string_view utf8) {
  return static_cast<std::size_t>(std::count_if(utf8.begin(), utf8.end(), [](char c) { return !is_continuation(c); }));
}

std::string left(std::string_view utf8, std::size_t columns) {
  const std::size_t have = width(utf8);
  if (have <= columns) return std::string(utf8) + std::string(columns - have, ' ');
  std::size_t end = 0;
  for (std::size_t kept = 0; end < utf8.size(); ++end) {
    if (!is_continuation(utf8[end]) && ++kept >= columns) break;  // room for the ellipsis
  }
  return std::string(utf8.substr(0, end)) + (columns > 0 ? "…" : "");
}

std::string right(std::string_view utf8, std::size_t columns) {
  const std::size_t have = width(utf8);
  return std::string(columns > have ? columns - have : 0, ' ') + std::string(utf8);
}

std::string one_line(std::string_view text) {
  std::string out;
  for (const char c : clean_text(text)) {
    const bool blank = c == ' ' || c == '\n' || c == '\r' || c == '\t';
    if (!blank)
      out += c;
    else if (!out.empty() && out.back() != ' ')
      out += ' ';
  }
  if (!out.empty() && out.back() == ' ') out.pop_back();
  return out;
}

std::string summary_line(std::string_view name, std::string_view value) {
  constexpr std::size_t name_columns = 18, value_columns = 100;
  std::string out = "  " + left(name, name_columns);
  std::size_t column = 0;
  std::istringstream words(one_line(value));
  for (std::string word; words >> word; column += width(word)) {
    if (column > 0 && column + 1 + width(word) > value_columns) {
      out += "\n" + std::string(name_columns + 2, ' ');
      column = 0;
    }
    if (column > 0) {
      out += ' ';
      ++column;
    }
    out += word;
  }
  return out + "\n";
}

std::string number(double value, int digits) {
  if (std::isnan(value)) return "none";
  if (value == 0) value = 0;  // no "-0"
  return fmt::format("{:.{}g}", value, digits);
}

std::string error_number(double value, bool relative, int digits) {
  if (!relative || !std::isfinite(value)) return number(value, digits);
  return number(100 * value, digits) + " %";
}

std::string with_error(double value, double standard_error) {
  if (!std::isfinite(value) || !std::isfinite(standard_error))
    return number(value, 3) + " ± " + number(standard_error, 1);
  const int decimals = standard_error >= 0.01 ? 2 : 3;
  if (standard_error < 0.0005) return fmt::format("{:.3f} ± <0.001", value);
  return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, standard_error, decimals);
}

std::string typographic(std::string_view text) {
  std::string out;
  const std::size_t e = text.find('e');
  const bool scientific =
      e != std::string_view::npos && e > 0 && e + 1 < text.size() && (text[e + 1] == '-' || text[e + 1] == '+');
  for (const char c : scientific ? text.substr(0, e) : text) c == '-' ? out += "−" : out += c;
  if (!scientific) return out;
  const std::size_t tail = text.find(' ', e);  // "1e-05 %"
  out += "×10" + superscript(text.substr(e + 1, tail == std::string_view::npos ? tail : tail - e - 1));
  if (tail != std::string_view::npos) out += text.substr(tail);
  return out;
}

Scale readable_scale(double largest, std::string_view unit) {
  if (!std::isfinite(largest) || largest == 0) return {1, std::string(unit)};
  const int exponent = 3 * static_cast<int>(std::floor(std::log10(std::abs(largest) * (1 + 1e-12)) / 3));
  if (unit.empty() && exponent >= -3 && exponent <= 3) return {1, ""};
  if (exponent == 0) return {1, std::string(unit)};
  static constexpr std::array<std::string_view, 5> small{"m", "µ", "n", "p", "f"};
  if (takes_prefix(unit) && exponent < 0 && exponent >= -15) {
    return {std::pow(10, -exponent), std::string(small[std::size_t(-exponent / 3 - 1)]) + std::string(unit)};
  }
  if (takes_prefix(unit) && exponent > 0 && exponent <= 3) return {1, std::string(unit)};
  return {std::pow(10, -exponent), power_of_ten(exponent) + (unit.empty() ? "" : " ") + std::string(unit)};
}

std::string readable(double value, std::string_view unit, int digits) {
  if (!std::isfinite(value)) return number(value, digits);
  Scale scale = readable_scale(value, unit);
  if (scale.unit.rfind("10", 0) == 0) scale = {1, std::string(unit)};  // 2×10⁻⁹ kg m², not 2 10⁻⁹ kg m²
  return typographic(number(value * scale.factor, digits)) + (scale.unit.empty() ? "" : " ") + scale.unit;
}

}  // namespace handhold::reports
