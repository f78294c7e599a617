// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Private to the readers of traces: shows nlohmann::json.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cases/hand/trace.hpp"
#include "cases/input/trace/source_frame.hpp"

namespace handhold {

struct JointSet;

/// What the head of a recording of joints says of its numbers.
struct JointsFormat {
  const JointSet* set{};
  SourceFrame frame{1, 'y'};
  double ticks{1};   ///< of the file's time in a second
  bool wxyz{false};  ///< order of quaternions; else x, y, z, w
};

/// Throws InputError for unknown members and values.
[[nodiscard]] JointsFormat read_joints_format(const nlohmann::json& recording, const std::string& path);

/// A list of frames as the recording that it stands for; its first item may be a header without a frame.
[[nodiscard]] nlohmann::json as_recording(nlohmann::json value);

/// True for raw or packed frames of LeapJS.
[[nodiscard]] bool is_leap(const nlohmann::json& recording);

/// Frames of the LeapC interface, dumped member by member, as the frames of LeapJS that say the same; others unchanged.
[[nodiscard]] nlohmann::json from_leap_c(nlohmann::json recording);

/// The many ways to write joints as the one that joints_reader.hpp documents: recordings of the WebXR emulator, hands
/// as a list, joints by name, as numbers in a row, as x, y, z or as matrices, and other words for the same members.
/// `remarks` says what was assumed.
[[nodiscard]] nlohmann::json canonical_joints(nlohmann::json recording, const std::string& path,
                                              std::vector<std::string>& remarks);

/// What read_joints and read_leap do with parsed text.
[[nodiscard]] Trace joints_trace(nlohmann::json recording, const std::string& path,
                                 std::vector<std::string> remarks = {});
[[nodiscard]] Trace leap_trace(const nlohmann::json& recording, const std::string& path);

}  // namespace handhold
