// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mutator.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>

namespace handhold::fuzz {
namespace {

constexpr std::size_t largest = 4u << 20;

// Where counts, indices, sizes and coordinates go wrong.
const char* const numbers[] = {
    "0",       "-1",         "1",          "2",           "3",          "255",    "65536", "-0",
    "1e-9",    "0.001",      "1e3",        "1e30",        "1e308",      "1e999",  "nan",   "-inf",
    "1.#QNAN", "2147483647", "2147483648", "-2147483648", "4294967295", "1e-320", ".5",    "99999999",
    "0x10",    "1,5",        "true",       "null",        "\"\"",       "[]",     "{}",    "99999999999999999999"};

// What opens something that has to be closed.
const char* const openings[] = {
    "[", "{\"a\":", "[[", "\"", "a.", "{a=", "\\\n", "#", "\r", "f 1 2 3\n", "[[bodies]]\n"};

}  // namespace

// Splitmix64: Steele, Lea, Flood 2014.
std::uint64_t Mutator::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

Mutator::Range Mutator::range(const std::string& bytes, std::size_t longest) {
  const std::size_t at = below(bytes.size());
  return {at, std::min(1 + below(longest), bytes.size() - at)};
}

Mutator::Range Mutator::line(const std::string& bytes) {
  const std::size_t inside = below(bytes.size());
  const std::size_t before = bytes.rfind('\n', inside), after = bytes.find('\n', inside);
  const std::size_t at = before == std::string::npos || before == inside ? inside : before + 1;
  return {at, std::min({after == std::string::npos ? bytes.size() : after + 1, bytes.size(), at + 1000}) - at};
}

Mutator::Range Mutator::word(const std::string& bytes) {
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || (c && std::strchr("+-._", c));
  };
  Range found{below(bytes.size()), 0};
  while (found.at < bytes.size() && !in_word(bytes[found.at])) ++found.at;
  while (found.at > 0 && in_word(bytes[found.at - 1])) --found.at;
  while (found.at + found.length < bytes.size() && in_word(bytes[found.at + found.length])) ++found.length;
  return found;
}

void Mutator::change(std::string& bytes, const std::vector<std::string>& others) {
  if (bytes.empty()) bytes = "0";
  const Range part = range(bytes, 64), row = line(bytes), token = word(bytes);
  switch (below(14)) {
    case 0:
      bytes[part.at] = static_cast<char>(bytes[part.at] ^ 1 << below(8));
      break;
    case 1:
      bytes[part.at] = static_cast<char>(next());
      break;
    case 2:
      bytes.erase(part.at, part.length);
      break;
    case 3:
      bytes.erase(row.at, row.length);
      break;
    case 4:
      bytes.insert(below(bytes.size()), bytes.substr(part.at, part.length));
      break;
    case 5:
      bytes.insert(line(bytes).at, bytes.substr(row.at, row.length));
      break;
    case 6:
      bytes.resize(part.at);
      break;
    case 7:
    case 8:
    case 9:
      bytes.replace(token.at, token.length, numbers[below(std::size(numbers))]);
      break;
    case 10: {
      const Range other = word(bytes);
      bytes.replace(token.at, token.length, bytes.substr(other.at, other.length));
      break;
    }
    case 11: {  // a number of a binary file
      const std::uint64_t values[] = {0,          1,          3,          0x7f,         0xff,
                                      0x7fff,     0xffff,     0x7fffffff, 0x80000000,   0xffffffff,
                                      0x7fc00000, 0x7f800000, 0x01000000, bytes.size(), next()};
      const std::uint64_t value = values[below(std::size(values))];
      const std::size_t width = std::size_t{1} << below(4);
      std::memcpy(bytes.data() + part.at, &value, std::min({width, bytes.size() - part.at, sizeof(value)}));
      break;
    }
    case 12: {  // a line, an opening or a few bytes, thousands of times
      const std::size_t what = below(3), times = std::size_t{1} << below(17);
      const std::string piece = what == 0   ? bytes.substr(row.at, row.length)
                                : what == 1 ? std::string(openings[below(std::size(openings))])
                                            : bytes.substr(part.at, std::min<std::size_t>(part.length, 8));
      std::string many;
      for (std::size_t i = 0; i < times && many.size() < largest / 4; ++i) many += piece;
      bytes.insert(what == 0 ? row.at : part.at, many);
      break;
    }
    default: {
      const std::string& other = others[below(others.size())];
      const Range piece = range(other, 1000);
      bytes.replace(part.at, part.length, other.substr(piece.at, piece.length));
    }
  }
  if (bytes.size() > largest) bytes.resize(largest);
}

std::string Mutator::mutant(const std::string& seed, const std::vector<std::string>& others) {
  std::string bytes = seed;
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) change(bytes, others);
  return bytes;
}

}  // namespace handhold::fuzz
