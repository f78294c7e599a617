#pragma once

#include <string>

#include "cases/recording.hpp"
#include "compare/grasp.hpp"

namespace handhold::reports {

/// What one engine's recording shows, for the terminal: how the run ended, touches and slips, held or not and when,
/// penetration, frame times and the energy book.
[[nodiscard]] std::string grasp_text(const compare::GraspSummary& summary, const Recording& recording, double seconds);

/// How far the two engines' recordings of one scene are apart.
[[nodiscard]] std::string difference_text(const compare::Difference& difference);

}  // namespace handhold::reports
