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

/// All of them, in the order of the registry (engines.cpp); then those from npm that are installed.
[[nodiscard]] std::vector<std::string> engine_names();

// One function an engine, each in a file of its own.
[[nodiscard]] std::unique_ptr<Engine> make_reference_engine();        // reference_engine.cpp
[[nodiscard]] std::unique_ptr<Engine> make_rigid_engine();            // rigid_engine.cpp
[[nodiscard]] std::unique_ptr<Engine> make_realtime_engine();         // realtime_engine.cpp
[[nodiscard]] std::unique_ptr<Engine> make_kinematic_grasp_engine();  // baseline_engines.cpp
[[nodiscard]] std::unique_ptr<Engine> make_pinch_state_engine();      // baseline_engines.cpp
[[nodiscard]] std::unique_ptr<Engine> make_paper_engine();            // paper_engine.cpp
[[nodiscard]] std::unique_ptr<Engine> make_paper_coulomb_engine();    // paper_coulomb_engine.cpp

}  // namespace handhold::compare
