// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/model/recording.hpp"
#include "compare/engine/drawn_hand.hpp"
#include "compare/measure/grasp.hpp"
#include "compare/study/horizon.hpp"

namespace handhold::reports {

/// What one engine's recording shows, for the terminal: how the run ended, touches and slips, held or not and when,
/// penetration, frame times and the energy book.
[[nodiscard]] std::string grasp_text(const compare::GraspSummary& summary, const Recording& recording, double seconds);

/// Until when a recording's answer means something.
[[nodiscard]] std::string horizon_text(const compare::Horizon& horizon);

/// How far the two engines' recordings of one scene are apart up to `until` [s].
[[nodiscard]] std::string difference_text(const compare::Difference& difference, double until);

/// What the drawn hands show beside a recording: when they stood still, how deep they were against the tracked ones and
/// against the bound, and how they went back.
[[nodiscard]] std::string drawn_hands_text(const compare::DrawnHands& drawn);

}  // namespace handhold::reports
