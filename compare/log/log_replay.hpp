// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "cases/hand/placement.hpp"
#include "cases/model/body.hpp"
#include "compare/engine/engine.hpp"
#include "compare/log/log_judge.hpp"

namespace handhold::compare {

/// What an engine makes of a logged grip: the logged hand takes the object from where it was at rest in the hand.
struct LogReplay {
  double begin{};         ///< the object is put where the log had it then, and let go 50 ms later [s of the log]
  double played_until{};  ///< half a second beyond the log's last touch, or the end of the hand [s]
  std::optional<double> replayed_end{};  ///< last touch in the replay [s of the log]; none: touches to the end
  double apart{};                        ///< farthest that replay and log were apart while both held it [m]
  Outcome outcome{Outcome::complete};
};

/// `body`: the object with mass and friction; `contact_of` what suits the grip. None if the object is never at rest in
/// the hand: between the thumb and another part of it, and slower than 5 cm/s against the palm for 0.1 s.
[[nodiscard]] std::optional<LogReplay> replay_grip(const ObjectLog& log, const ObjectTrack& track, const LogGrip& grip,
                                                   const Body& body,
                                                   const std::function<ContactParameters(const Placement&)>& contact_of,
                                                   const Engine& engine);

}  // namespace handhold::compare
