// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Private to the readers of traces: shows nlohmann::json.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "cases/hand/trace.hpp"

namespace handhold {

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
