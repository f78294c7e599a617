// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/cli/progress.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>
#include <unistd.h>

#include "reports/data/text.hpp"

namespace handhold::reports {

bool may_colour(int stream) {
  const char* no_colour = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  if (no_colour != nullptr && *no_colour != '\0') return false;
  return ::isatty(stream) == 1 && terminal != nullptr && std::strcmp(terminal, "dumb") != 0;
}

ProgressLine::ProgressLine(Elsewhere elsewhere)
    : elsewhere_(elsewhere), terminal_(::isatty(2) == 1), start_(Clock::now()) {}

ProgressLine::~ProgressLine() {
  if (terminal_) std::fputs("\r\x1b[K", stderr);
}

void ProgressLine::step(const std::string& what) {
  step_ = one_line(what);
  if (terminal_) return show(step_);
  if (elsewhere_ == Elsewhere::lines) std::fputs((step_ + "\n").c_str(), stderr);
}

void ProgressLine::update(const std::string& how_far) {
  if (terminal_ && Clock::now() - shown_ > std::chrono::milliseconds(100)) show(step_ + "  " + how_far);
}

void ProgressLine::show(const std::string& line) {
  shown_ = Clock::now();
  const double seconds = std::chrono::duration<double>(shown_ - start_).count();
  std::string text = fmt::format("{:5.1f} s  {}", seconds, line);
  if (width(text) > 78) text = left(text, 78);  // a line that wraps cannot be written over
  std::fputs(("\r\x1b[K" + text).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace handhold::reports
