// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/log/log_judge.hpp"
#include "compare/log/object_track.hpp"

namespace handhold::compare {

/// Standard errors of a fit that every limit leaves beside what its reason says.
inline constexpr double limit_errors = 3;

/// Frames [begin, end) of a track.
struct Span {
  std::size_t begin{}, end{};
};

/// One object of a log with all that its motion is judged against.
struct LoggedMotion {
  const ObjectLog& log;
  const LoggedHands& hands;
  const std::vector<ObjectTrack>& tracks;  ///< of all objects
  const std::vector<LoggedSolid>& solids;
  std::size_t object;       ///< which of them
  Eigen::Vector3d gravity;  ///< in W [m/s^2]

  [[nodiscard]] const ObjectTrack& track() const { return tracks[object]; }
  /// No phalanx reaches the object at stamp `i`.
  [[nodiscard]] bool away(std::size_t i) const { return track().near[i].depth < -away_distance; }
  /// Another object may touch this one at time `t`: their circumscribed spheres meet.
  [[nodiscard]] bool beside_another(double t) const;
  /// Of a hand from one time to the other [m/s].
  [[nodiscard]] double fastest_phalanx(int hand, double from, double to) const;
  [[nodiscard]] std::string hand_name(int hand) const;  ///< "right hand"
  /// Along gravity; without gravity its length.
  [[nodiscard]] double downwards(const Eigen::Vector3d& v) const {
    return gravity.norm() > 0 ? v.dot(gravity.normalized()) : v.norm();
  }
};

/// Findings of one object. One finding goes on where the same fault goes on, and keeps the worst figure.
class LogFindings {
 public:
  void add(LogFinding finding);
  [[nodiscard]] std::vector<LogFinding> take() { return std::move(findings_); }

 private:
  std::vector<LogFinding> findings_{};
};

/// Frames from which the object jumps to the next.
[[nodiscard]] std::vector<std::size_t> find_jumps(const LoggedMotion& motion, LogFindings& findings);
/// Flight over 0.1 s and drift over 0.5 s with every hand away, in a span without jumps.
void find_free_motion(const LoggedMotion& motion, const Span& span, LogFindings& findings);
void find_kicks(const LoggedMotion& motion, const Span& span, LogFindings& findings);
/// Grips, ascending in time, and how the object creeps in them.
[[nodiscard]] std::vector<LogGrip> find_grips(const LoggedMotion& motion, LogFindings& findings);
void find_penetration(const LoggedMotion& motion, LogFindings& findings);

}  // namespace handhold::compare
