// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/engines.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/model/input_error.hpp"
#include "compare/engine/process_engine.hpp"

namespace handhold::compare {

// CMake writes registry.inc from registry.cmake, in which an engine is a line.
#define HANDHOLD_ENGINE(name, make) std::unique_ptr<Engine> make();
#include "compare/registry.inc"
#undef HANDHOLD_ENGINE

namespace {

struct Entry {
  const char* name;
  std::unique_ptr<Engine> (*make)();
};

constexpr std::array registry{
#define HANDHOLD_ENGINE(name, make) Entry{name, make},
#include "compare/registry.inc"
#undef HANDHOLD_ENGINE
};

}  // namespace

std::unique_ptr<Engine> make_engine(const std::string& name) {
  for (const Entry& entry : registry)
    if (name == entry.name) return entry.make();
  const std::vector<std::string> npm = npm_engine_names();
  if (std::ranges::find(npm, name) != npm.end()) return make_npm_engine(name);
  throw InputError(fmt::format("engine '{}': no such engine (there are {})", name, fmt::join(engine_names(), ", ")));
}

std::vector<std::string> engine_names() {
  std::vector<std::string> names;
  for (const Entry& entry : registry) names.emplace_back(entry.name);
  for (const std::string& name : npm_engine_names())
    if (npm_engine_is_installed(name)) names.push_back(name);
  return names;
}

}  // namespace handhold::compare
