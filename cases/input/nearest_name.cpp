// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/input/nearest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace handhold {
namespace {

constexpr std::size_t longest = 64;  // nobody mistypes more; keeps hostile input cheap

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(std::string_view given, const std::vector<std::string>& names) {
  given = given.substr(0, longest);
  std::string best;
  std::size_t least = longest;
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(given, name);
    if (distance < least && 2 * distance <= std::max(given.size(), name.size())) {
      least = distance;
      best = name;
    }
  }
  return best;
}

std::string join_names(const std::vector<std::string>& names) {
  std::string joined;
  for (const std::string& name : names) joined += (joined.empty() ? "" : ", ") + name;
  return joined;
}

}  // namespace handhold
