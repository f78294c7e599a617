// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "cases/hand/trace.hpp"

namespace handhold {

/// A LeapJS playback recording (`.json`, or LZString-packed `.json.lz`): raw frames (objects) or packed ones (arrays,
/// with the columns in the first). mm, µs, y up; confidence 1 where the file has none.
///
/// Fingers are told apart by hand id and type (their order changes within a file), or by their order where old files
/// have no type. The palm's pose is the recorded palm position, direction and normal. `metadata.frames` is not trusted.
/// `path` starts every error: broken JSON or LZString (with the byte), no frames, no hand, time that goes back.
[[nodiscard]] Trace read_leap(std::string_view text, const std::string& path);

}  // namespace handhold
