// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/study/grasp_table.hpp"

namespace handhold::reports {

/// One line a pair: placed how, held how long by each engine, difference, horizon, costs; below it why one that does
/// not hold is lost.
[[nodiscard]] std::string grasp_row_text(const compare::GraspRow& row);

/// The head of the columns of those lines.
[[nodiscard]] std::string grasp_table_head(const std::vector<std::string>& engines);

/// How many pairs were placed, held, and refused, and what placing cost.
[[nodiscard]] std::string grasp_totals(const std::vector<compare::GraspRow>& rows);

/// {"grasps": [{...}]}, lengths in metres, times in seconds, masses in kilograms.
[[nodiscard]] std::string grasp_table_json(const std::vector<compare::GraspRow>& rows);

}  // namespace handhold::reports
