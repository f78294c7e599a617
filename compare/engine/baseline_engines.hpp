#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compare/engine/engine.hpp"

namespace handhold::compare {

/// "kinematic-grasp" and "pinch-state": the interaction methods that the paper's study compares with.
[[nodiscard]] std::vector<std::string> baseline_engine_names();

/// The baseline of that name, stepped at the frame rate; nothing for any other name.
[[nodiscard]] std::unique_ptr<Engine> make_baseline_engine(const std::string& name);

}  // namespace handhold::compare
