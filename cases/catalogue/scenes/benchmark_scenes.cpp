// SPDX-License-Identifier: GPL-3.0-or-later
#include "cases/catalogue/scenes/benchmark_scenes.hpp"

#include <functional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/catalogue/builders/scenes.hpp"
#include "cases/catalogue/scenes/benchmark_families.hpp"
#include "cases/model/input_error.hpp"

namespace handhold::catalogue {
namespace {

using Entry = std::pair<std::string, std::function<BenchmarkScene()>>;

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      {"S1", pinch_benchmark},
      {"S2", [] { return two_hand_grip({}); }},
      {"S3-24", [] { return incline_benchmark(24); }},
      {"S3-26", [] { return incline_benchmark(26); }},
      {"S3-30", [] { return incline_benchmark(30); }},
      {"S3-45", [] { return incline_benchmark(45); }},
      {"S3-stop-0", [] { return stopping_benchmark(0); }},
      {"S3-stop-30", [] { return stopping_benchmark(30); }},
      {"S3-stop-45", [] { return stopping_benchmark(45); }},
      {"S4a", axe_benchmark},
      {"S4a-rest", [] { return tower(5, 4, 10); }},
      {"S4b", jenga_benchmark},
      {"S5a", [] { return swing_benchmark(false); }},
      {"S5b", [] { return swing_benchmark(true); }},
      {"S6a", [] { return cup_benchmark(false); }},
      {"S6b", [] { return cup_benchmark(true); }},
  };
  return all;
}

}  // namespace

const std::vector<std::string>& benchmark_ids() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> list;
    for (const auto& [id, build] : entries()) list.push_back(id);
    return list;
  }();
  return ids;
}

BenchmarkScene benchmark_scene(std::string_view id) {
  for (const auto& [known, build] : entries()) {
    if (known != id) continue;
    BenchmarkScene made = build();
    made.id = known;
    made.scene.name = fmt::format("{} {}", known, made.title);
    return made;
  }
  throw InputError(fmt::format("benchmark scene '{}': there is none of that id (use one of {})", id,
                               fmt::join(benchmark_ids(), ", ")));
}

Body benchmark_block(const std::string& name, const Eigen::Vector3d& half, double voxel_size, double mass,
                     const Friction& friction) {
  Body body = block(2 * half, voxel_size, mass, friction);
  body.name = name;
  return body;
}

}  // namespace handhold::catalogue
