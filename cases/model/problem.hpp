#pragma once

#include <string_view>
#include <variant>

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
using Problem = std::variant<Scene, RigidProblem>;

[[nodiscard]] inline Level level_of(const Problem& problem) {
  return std::holds_alternative<RigidProblem>(problem) ? Level::rigid : Level::compliant;
}

[[nodiscard]] inline double duration_of(const Problem& problem) {
  return std::visit([](const auto& p) { return p.duration; }, problem);
}

}  // namespace handhold
