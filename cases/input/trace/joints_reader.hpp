// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "cases/hand/trace.hpp"

namespace handhold {

/// Joints of tracked hands as plain JSON: what a few lines around an OpenXR or WebXR frame loop write.
///
///     {"format": "openxr",           "openxr" (26 joints), "webxr" (25), "mano" (21), ... (joint_sets.hpp)
///      "unit": "m", "up": "y",       m, cm or mm; x, y, z, or -y and so on; these are the defaults
///      "handedness": "right",        of the coordinates, or "left"
///      "time": "s",                  s, ms, us or ns
///      "quaternion": "xyzw",         or "wxyz"
///      "frames": [
///        {"t": 0.011,                seconds, increasing
///         "hands": {"right": {"confidence": 0.9,
///                             "joints": [{"name": "wrist", "position": [0, 1, 0], "orientation": [0, 0, 0, 1],
///                                         "radius": 0.02}, null, ...]},
///                   "left": null}}]}
///
/// Joints come in the order of the specification, or named, in any order. `orientation` (x, y, z, w; -z towards the
/// fingertip and y dorsal) and `radius` may be absent; a null joint or hand, or a NaN, is an untracked one. Other ways
/// to write the same are made this one first (json_readers.hpp); unknown members are an error, and "objects" is left to
/// input/log/object_log.hpp. `path` starts every error.
[[nodiscard]] Trace read_joints(std::string_view text, const std::string& path);

}  // namespace handhold
