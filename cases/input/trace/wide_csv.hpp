// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "cases/hand/trace.hpp"

namespace handhold {

/// The first line names columns (comma, semicolon or tab), one of them the time and others coordinates.
[[nodiscard]] bool is_wide_csv(std::string_view text);

/// Joints with a column a coordinate and a line a frame:
///
///     time,right_wrist_x,right_wrist_y,right_wrist_z,right_index_tip_x, ...
///
/// Joints by any name that joints_reader.hpp knows, in metres and seconds, y up; x, y, z (or px ...) of the position,
/// qx, qy, qz, qw of the orientation. Without left or right in the names the hand is taken as a right one, with a
/// warning. Empty fields and NaN are untracked. Throws InputError with file and line.
[[nodiscard]] Trace read_wide_csv(std::string_view text, const std::string& path);

}  // namespace handhold
