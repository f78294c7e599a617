// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace handhold::fuzz {

struct SeedFile {
  std::string name{};  ///< within the folder it is read from
  std::string bytes{};
};

/// Files that the program reads in one way.
struct InputKind {
  std::string name{};
  std::vector<SeedFile> seeds{};                                ///< well-formed; mutants are made of them
  std::vector<SeedFile> beside{};                               ///< stays in the folder as it is
  std::function<void(const std::filesystem::path& file)> read;  ///< what the command does with it, until it would play
};

/// Meshes of every format, hands, scenes, recordings, files of voxels and cache entries.
[[nodiscard]] std::vector<InputKind> input_kinds();

}  // namespace handhold::fuzz
