// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace handhold::reports {

/// What is wrong with the nesting, the quotes or the entities of XML (or of our HTML), in words; empty if nothing is.
/// Knows no DTD.
inline std::string markup_fault(std::string_view text) {
  std::vector<std::string> open;
  std::size_t i = 0;
  while (i < text.size()) {
    if (text[i] == '&') {
      const std::size_t end = text.find(';', i);
      const std::string name(text.substr(i + 1, end == std::string_view::npos ? 0 : end - i - 1));
      const bool good = !name.empty() && name.size() < 8 &&
                        std::all_of(name.begin(), name.end(), [](char c) { return std::isalnum(c) || c == '#'; });
      if (!good) return "bare & at " + std::string(text.substr(i, 20));
    }
    if (text[i] == '>') return "bare > at " + std::string(text.substr(i > 20 ? i - 20 : 0, 30));
    if (text[i] != '<') {
      ++i;
      continue;
    }
    const std::size_t begin = i + 1;
    char quote = 0;
    for (++i; i < text.size() && (quote != 0 || text[i] != '>'); ++i) {
      if (text[i] == '<') return "< inside a tag: " + std::string(text.substr(begin, i - begin));
      if (quote != 0 ? text[i] == quote : text[i] == '"' || text[i] == '\'') quote = quote != 0 ? char(0) : text[i];
    }
    if (i == text.size()) return "tag without end";
    const std::string_view tag = text.substr(begin, i++ - begin);
    const std::string name(tag.substr(0, tag.find_first_of(" \n/", 1)));
    if (tag[0] == '?' || tag[0] == '!' || tag.back() == '/' || name == "meta") continue;
    if (tag[0] != '/') {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != tag) {
      return "</" + (open.empty() ? std::string("nothing") : open.back()) + "> expected, <" + std::string(tag) +
             "> found";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

inline std::size_t occurrences(std::string_view text, std::string_view wanted) {
  std::size_t out = 0;
  for (std::size_t at = text.find(wanted); at != std::string_view::npos; at = text.find(wanted, at + 1)) ++out;
  return out;
}

}  // namespace handhold::reports
