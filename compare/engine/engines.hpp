// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compare/engine/engine.hpp"

namespace handhold::compare {

/// The engine of that name; throws InputError listing the names otherwise. Engines on Simbody are absent in builds
/// without it.
[[nodiscard]] std::unique_ptr<Engine> make_engine(const std::string& name);

/// All of them, in the order of registry.cmake; then those from npm that are installed.
[[nodiscard]] std::vector<std::string> engine_names();

}  // namespace handhold::compare
