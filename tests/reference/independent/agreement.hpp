// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/model/recording.hpp"
#include "tests/reference/independent/solver.hpp"

namespace handhold::independent {

/// How far two answers to one scene are apart.
struct Agreement {
  double position{};            ///< of O's origin at the end [m]
  double rotation{};            ///< at the end [rad]
  double event_time{};          ///< the worst, per contact and in order [s]; meaningless unless the lists agree
  std::string events_differ{};  ///< empty: every contact has the same kinds in the same order
};

[[nodiscard]] Agreement agreement(const Result& a, const Result& b);
[[nodiscard]] Agreement agreement(const Result& truth, const Recording& recording);

/// "position 1.2e-10 m, rotation ..., event times ..., the same 66 events"
[[nodiscard]] std::string text(const Agreement& a, std::size_t events);

}  // namespace handhold::independent
