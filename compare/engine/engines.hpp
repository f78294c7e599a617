#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compare/engine/engine.hpp"

namespace handhold::compare {

/// The engine of that name: "reference" (absent in builds without Simbody), "realtime" or a baseline of the paper's
/// study (compare/engine/baseline_engines.hpp); throws InputError otherwise.
[[nodiscard]] std::unique_ptr<Engine> make_engine(const std::string& name);

[[nodiscard]] std::vector<std::string> engine_names();

}  // namespace handhold::compare
