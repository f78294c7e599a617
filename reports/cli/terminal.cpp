// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/terminal.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "cases/input/text_encoding.hpp"

namespace handhold::reports {

void say(std::string_view lines) {
  std::string text = clean_text(lines);
  std::replace(text.begin(), text.end(), '\r', ' ');  // it would write over the line
  fmt::print("{}", text);
}

}  // namespace handhold::reports
