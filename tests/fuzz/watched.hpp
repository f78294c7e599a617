// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

namespace handhold::fuzz {

/// What happened to trials of one kind.
struct Tally {
  std::size_t trials{}, read{}, refused{};
  std::size_t signals{}, hangs{}, other_errors{}, too_much_memory{};
  double slowest{};      ///< [s]
  double most_memory{};  ///< peak of one trial [MB]

  [[nodiscard]] std::size_t faults() const { return signals + hangs + other_errors + too_much_memory; }
};

/// One trial: writes the file of this number and returns it, then reads it.
struct Trial {
  std::function<std::filesystem::path(std::size_t number)> write;
  std::function<void(const std::filesystem::path& file)> read;
};

/// Plays trials `first` to `end` in child processes; one that dies, hangs or takes too much memory is replaced, and
/// `fault` told about it. Reading may throw InputError of one line; anything else is a fault: a signal, another
/// exception, more than 10 s, or more memory than 1 GB and 20 times the file. (Under a sanitizer neither time nor
/// memory are what they are without: a minute, and no limit.)
void play_watched(const Trial& trial, std::size_t first, std::size_t end, Tally& tally,
                  const std::function<void(std::size_t number, const std::string& what)>& fault);

}  // namespace handhold::fuzz
