// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "cases/model/recording.hpp"

// A recording as a folder of CSV files that any program can write and read. Units stand in the column names; numbers
// have as many digits as it takes to read the same bits back; `nan` and `inf` are numbers (of a run that diverged).
//
//   frames.csv       t_s; for every body in order its pose and twist in W (NAME.x_m, .y_m, .z_m, .qw, .qx, .qy, .qz,
//                    .vx_m_per_s, ..., .wx_rad_per_s, ...); kinetic_J, potential_J, elastic_J, dissipated_J,
//                    hand_work_J (read as nan where a file leaves the five out)
//   contacts.csv     frame (its number in frames.csv, from 0), t_s, hand, phalanx, body, sample (as in SampleId),
//                    mode (apart, stick, slip), depth_m, p, C and n in W, force on the object f in N
//   events.csv       t_s, window_s, kind (touch, breakaway, restick, release), hand, phalanx, body, sample; pose
//                    and twist of that body at that time, as in frames.csv
//   frame_times.csv  advance, cpu_time_s; no rows when not measured
//   ambiguities.csv  t_s, hand, phalanx, body, sample, what: where the law has no unique continuation
//
// Every file begins with lines `# key: value`: format, engine, scene, outcome (complete, interrupted, diverged,
// stalled), note, one `body` for each name, then the provenance as `provenance.KEY`. In them a backslash is \\, a line
// break \n, a carriage return \r, and a colon in a key \c.

namespace handhold {

/// Writes the five files into `folder`, which is made if need be. All are first written beside (`*.part`), then
/// renamed, so that a full disk or an interruption leaves what was there. Throws InputError if the folder cannot be
/// written.
void write_recording(const Recording& recording, const std::filesystem::path& folder);

/// Reads back what write_recording, or another engine, wrote: the same to the last bit. frames.csv must be there, the
/// others may be absent. Throws InputError naming file and line for a missing column, a bad number, a frame out of
/// range.
[[nodiscard]] Recording read_recording(const std::filesystem::path& folder);

}  // namespace handhold
