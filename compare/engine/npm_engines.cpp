// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/model/input_error.hpp"
#include "compare/engine/process_engine.hpp"

namespace handhold::compare {
namespace {

namespace fs = std::filesystem;

struct Package {
  const char* engine;
  const char* package;
};

constexpr std::array packages{
    Package{"rapier", "@dimforge/rapier3d-compat"},
    Package{"jolt", "jolt-physics"},
    Package{"havok", "@babylonjs/havok"},
    Package{"physx", "physx-js-webidl"},
    Package{"mujoco", "@mujoco/mujoco"},
};

fs::path folder() {
  const char* given = std::getenv("HANDHOLD_ENGINES");
  return fs::absolute(given && *given ? given : "build/engines");
}

}  // namespace

std::vector<std::string> npm_engine_names() {
  std::vector<std::string> names;
  for (const Package& p : packages) names.emplace_back(p.engine);
  return names;
}

bool npm_engine_is_installed(const std::string& name) {
  const auto found = std::ranges::find(packages, name, &Package::engine);
  return found != packages.end() && fs::exists(folder() / "play.mjs") &&
         fs::exists(folder() / "node_modules" / found->package / "package.json");
}

std::unique_ptr<Engine> make_npm_engine(const std::string& name) {
  const std::vector<std::string> names = npm_engine_names();
  if (std::ranges::find(names, name) == names.end())
    throw InputError(fmt::format("engine '{}': is none of npm's (there are {})", name, fmt::join(names, ", ")));
  if (!npm_engine_is_installed(name))
    throw InputError(
        fmt::format("engine '{}': is not in {} (./dev engines installs it; HANDHOLD_ENGINES names another folder)",
                    name, folder().string()));
  const std::string program = (folder() / "play.mjs").string();
  return make_process_engine(name, {.command = fmt::format("node '{}' {} {{problem}} {{out}}", program, name)});
}

}  // namespace handhold::compare
