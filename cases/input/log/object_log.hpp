// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cases/hand/trace.hpp"
#include "cases/model/pose.hpp"

namespace handhold {

/// An object as an application moved it.
struct LoggedObject {
  std::string name{};
  std::string shape{};           ///< mesh file, or "shape:<kind>,..."; empty: unknown
  double scale{1};               ///< of the mesh file's units in metres
  std::optional<double> mass{};  ///< [kg]
  std::optional<double> mu_static{}, mu_dynamic{};
  std::vector<std::optional<Pose>> X_WO{};  ///< one a stamp of the log; none: not logged then
};

/// What an application wrote of hands and objects, frame by frame.
struct ObjectLog {
  std::string name{};
  std::vector<double> t{};  ///< strictly increasing [s]
  std::vector<LoggedObject> objects{};
  bool drawn_hands{false};       ///< the hands are as drawn, not as tracked
  std::optional<Trace> trace{};  ///< of the hands, by the log's clock; none if the log has no hand
  std::vector<std::string> warnings{};
};

/// A log as JSON, whole or a line a frame after a line of head: a recording of joints (trace/joints_reader.hpp) with
/// objects in head and frames.
///
///     {"format": "openxr", "unit": "m", "up": "y", "drawn_hands": true,
///      "objects": {"cube": {"shape": "shape:box,x=0.05,y=0.05,z=0.05", "mass": 0.1, "friction": 0.46}}}
///     {"t": 0.011, "hands": {"right": {"joints": [...]}},
///      "objects": {"cube": {"position": [0, 1, 0], "orientation": [0, 0, 0, 1]}}}
///
/// Axes, unit, time and order of quaternions are those of the head, for joints and objects alike; a shape's coordinates
/// are those of the object's own frame. `friction` is static; "friction_dynamic" may be given beside it. Throws
/// InputError.
[[nodiscard]] ObjectLog read_object_log(const std::string& path);

}  // namespace handhold
