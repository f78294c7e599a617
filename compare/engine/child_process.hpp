// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace handhold::compare {

struct ChildEnd {
  bool timed_out{false};
  int exit_code{-1};  ///< if it ended by itself
  int signal{0};      ///< if a signal ended it
};

/// Runs `command` with /bin/sh in a process group of its own, input empty, both outputs into the file `output`. After
/// `time_limit` [s] and in any case at its end, whatever is left of the group is killed. A file it writes may grow to 1
/// GiB. Throws InputError if no process can be started.
[[nodiscard]] ChildEnd run_command(const std::string& command, double time_limit, const std::filesystem::path& output);

}  // namespace handhold::compare
