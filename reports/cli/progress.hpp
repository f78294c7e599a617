// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>

namespace handhold::reports {

/// True when the stream (1 output, 2 errors) is a terminal that may be given colours: NO_COLOR is not set, TERM is not
/// "dumb".
[[nodiscard]] bool may_colour(int stream);

/// What long work is at, on standard error: one line that is written over on a terminal, a line a step, or nothing,
/// elsewhere.
class ProgressLine {
 public:
  enum class Elsewhere { lines, silent };

  /// `elsewhere`: what is written when standard error is no terminal.
  explicit ProgressLine(Elsewhere elsewhere = Elsewhere::lines);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine();

  /// A new step begins.
  void step(const std::string& what);

  /// The step goes on; seen on a terminal only, at most ten times a second.
  void update(const std::string& how_far);

 private:
  void show(const std::string& line);

  using Clock = std::chrono::steady_clock;
  Elsewhere elsewhere_{};
  bool terminal_{};
  std::string step_{};
  Clock::time_point start_{}, shown_{};
};

}  // namespace handhold::reports
