// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cases/hand/trace.hpp"

namespace handhold {

struct TraceReadOptions {
  bool trust{false};     ///< what looks meaningless is a warning, not an error
  bool repair{false};    ///< glitches of one to three frames are bridged
  double scale{1};       ///< of all lengths, for a file whose unit is wrong
  double time_scale{1};  ///< of all times
};

/// A recording of hands from a file, gzip or not: handhold's own CSV (trace_csv.hpp), LeapJS playback `.json` and
/// `.json.lz` (leap_reader.hpp), frames of LeapC, joints of OpenXR, WebXR, MANO, MediaPipe and others as JSON
/// (joints_reader.hpp) or with a column a coordinate (wide_csv.hpp). The content decides, not the name (but a damaged
/// `.lz` is told by its name).
///
/// What the data makes doubtful (trace_doubts.hpp, trace_glitches.hpp) is among the trace's warnings. Throws InputError
/// that starts with `path` for files it cannot read, for formats it does not know, and for data whose simulation would
/// mean nothing unless they are trusted.
[[nodiscard]] Trace read_trace(const std::string& path, const TraceReadOptions& options = {});

}  // namespace handhold
