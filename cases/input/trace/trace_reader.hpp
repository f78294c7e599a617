// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/hand/trace.hpp"

namespace handhold {

/// A recording of hands from a file: handhold's own CSV (trace_csv.hpp), LeapJS playback `.json` and `.json.lz`
/// (leap_reader.hpp), or joints of OpenXR, WebXR and others as JSON (joints_reader.hpp). The content decides, not the
/// name (but a damaged `.lz` is told by its name). Throws InputError that starts with `path`, for files it cannot read
/// and for formats it does not know.
[[nodiscard]] Trace read_trace(const std::string& path);

}  // namespace handhold
