// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "cases/hand/trace.hpp"

namespace handhold {

/// handhold's own trace file: text, one phalanx a line.
///
///     # handhold trace 1
///     # name grab
///     # unit m                          m, cm or mm; default m
///     # up z                            x, y or z, or -x, -y or -z; default z
///     # handedness right                of the coordinates, right or left; default right
///     # time s                          s, ms, us or ns; default s
///     # capsule 0 index_distal 0.0053 0.009     hand, phalanx, half length, radius; in the unit above
///     # palm 0 0.04 0.014 0.0448                hand, half extents
///     t,hand,side,phalanx,px,py,pz,qw,qx,qy,qz,confidence
///     0,0,right,thumb_metacarpal,0.1,0.2,0.3,1,0,0,0,0.98
///     0,1,left,lost,,,,,,,,0
///
/// Frames as in hand_model.hpp; a hand without shapes gets the anatomical one. Lines of one time stamp stand together.
/// What describes the coordinates stands above shapes and poses. A hand is lost where its line says `lost`, where one
/// of its 16 phalanges is missing, or where a number is nan; warnings count the last two. A phalanx given twice at one
/// stamp: the later one is dropped, with a warning. Other lines that start with # are comments. Throws InputError with
/// file and line for everything else.
[[nodiscard]] Trace read_trace_csv(std::string_view text, const std::string& path);

/// Writes a trace so that reading it gives the same numbers: beside `path`, then renamed. Throws InputError if the file
/// cannot be written; what was there stays.
void write_trace_csv(const Trace& trace, const std::string& path);
[[nodiscard]] std::string to_csv(const Trace& trace);

}  // namespace handhold
