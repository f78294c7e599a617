// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "compare/engine/engine.hpp"
#include "compare/engine/process.hpp"

namespace handhold::compare {

/// A process as an engine of rigid problems (L1), graded, with step 1 / (frame_rate substeps). Whether it can express a
/// problem it is asked with a run of one step. A run that fails is a recording without frames, whose note says why.
[[nodiscard]] std::unique_ptr<Engine> make_process_engine(const std::string& name, const ProcessOptions& options);

/// The same from "NAME=COMMAND", e.g. "mine=python3 mine.py {problem} {out}". Throws InputError for another text.
[[nodiscard]] std::unique_ptr<Engine> process_engine_from(const std::string& text);

/// Engines from npm (compare/engine/node). They lie in the folder HANDHOLD_ENGINES, or build/engines, where ./dev
/// engines puts them.
[[nodiscard]] std::vector<std::string> npm_engine_names();
[[nodiscard]] bool npm_engine_is_installed(const std::string& name);

/// Throws InputError for a name that is not one of them, and for one that is not installed.
[[nodiscard]] std::unique_ptr<Engine> make_npm_engine(const std::string& name);

/// What is missing for a command to be an engine, in sentences, from two small problems that it is given: a block that
/// slides to a stop, and one that a hand presses. Empty: nothing.
[[nodiscard]] std::vector<std::string> what_is_missing(const ProcessOptions& options);

}  // namespace handhold::compare
