// SPDX-License-Identifier: Apache-2.0
#include "cases/model/recording.hpp"

#include <algorithm>
#include <cmath>

namespace handhold {

std::string_view to_string(Mode mode) {
  switch (mode) {
    case Mode::apart:
      return "apart";
    case Mode::stick:
      return "stick";
    case Mode::slip:
      return "slip";
  }
  return "unknown";
}

std::string_view to_string(EventKind kind) {
  switch (kind) {
    case EventKind::touch:
      return "touch";
    case EventKind::breakaway:
      return "breakaway";
    case EventKind::restick:
      return "restick";
    case EventKind::release:
      return "release";
  }
  return "unknown";
}

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::complete:
      return "complete";
    case Outcome::interrupted:
      return "interrupted";
    case Outcome::diverged:
      return "diverged";
    case Outcome::stalled:
      return "stalled";
  }
  return "unknown";
}

double energy_residual(const Recording& recording) {
  double worst = 0;
  for (const Frame& frame : recording.frames) {
    const double change = std::abs(energy_sum(frame.energy) - energy_sum(recording.frames.front().energy));
    if (std::isnan(change)) return change;  // never hidden by a maximum
    worst = std::max(worst, change);
  }
  return worst;
}

}  // namespace handhold
