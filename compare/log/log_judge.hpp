// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compare/log/object_track.hpp"
#include "compare/measure/timing.hpp"

namespace handhold::compare {

/// What no rigid body with Coulomb friction does, whatever engine moved it.
enum class LogFault {
  jump,         ///< in one frame farther than its speed before and after explains
  flight,       ///< in the air, not accelerated as by gravity
  drift,        ///< moves slowly and steadily with no hand near
  kick,         ///< leaves a hand faster than any blow of that hand explains
  creep,        ///< slides steadily through a hand that keeps still
  penetration,  ///< a bone of a drawn hand is inside it
};

[[nodiscard]] std::string_view to_string(LogFault fault);

struct LogFinding {
  LogFault fault{};
  std::string object{};
  double begin{}, end{};    ///< [s]
  double value{}, limit{};  ///< in `unit`
  std::string unit{};
  std::string text{};    ///< what happened, with its figures
  std::string reason{};  ///< why that cannot be, and where the limit is from
};

/// A stretch of time in which one hand holds the object: in touch, never seen apart for over 0.1 s, for 0.2 s at least.
struct LogGrip {
  std::string object{};
  std::size_t track{};    ///< number of the object
  int hand{};             ///< number of the hand in the trace
  double begin{}, end{};  ///< first and last touch [s]
  double depth{};         ///< deepest of any phalanx but the palm [m]
  /// Rms of the object in the palm about its steady motion, over the stillest half second [m]; NaN if there is none.
  double jitter{};
};

struct LogReport {
  std::vector<LogFinding> findings{};  ///< ascending in time
  std::vector<LogGrip> grips{};        ///< ascending in time
  FrameTimes frames{};                 ///< from one stamp to the next
};

/// Judges what needs no engine. Every limit is three standard errors of the fit beside what `reason` says, so that a
/// log's rounding raises no alarm; objects near each other excuse flight, drift and kick.
[[nodiscard]] LogReport judge_log(const ObjectLog& log, const std::vector<ObjectTrack>& tracks,
                                  const std::vector<LoggedSolid>& solids,
                                  const Eigen::Vector3d& gravity = {0, 0, -9.81});

}  // namespace handhold::compare
