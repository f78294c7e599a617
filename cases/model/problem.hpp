// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <variant>

#include "cases/model/printed_problem.hpp"
#include "cases/model/rigid_problem.hpp"
#include "cases/model/scene.hpp"

namespace handhold {

/// The three models of contact that a problem can be of (docs/contact-law.md).
enum class Level {
  rigid,      ///< L1: rigid bodies under Coulomb friction with exact stiction
  compliant,  ///< L2: the contact element, spring and damper in series with a Coulomb slider
  printed,    ///< L3: the law of Höll et al. 2018 to the letter, one step a frame
};

/// "L1", "L2", "L3".
[[nodiscard]] constexpr std::string_view to_string(Level level) {
  return level == Level::rigid ? "L1" : level == Level::compliant ? "L2" : "L3";
}

/// What an engine is asked to simulate.
using Problem = std::variant<Scene, RigidProblem, PrintedProblem>;

[[nodiscard]] inline Level level_of(const Problem& problem) {
  if (std::holds_alternative<RigidProblem>(problem)) return Level::rigid;
  return std::holds_alternative<PrintedProblem>(problem) ? Level::printed : Level::compliant;
}

[[nodiscard]] inline double duration_of(const Problem& problem) {
  if (const auto* printed = std::get_if<PrintedProblem>(&problem)) return printed->frames * printed->frame;
  if (const auto* rigid = std::get_if<RigidProblem>(&problem)) return rigid->duration;
  return std::get<Scene>(problem).duration;
}

}  // namespace handhold
