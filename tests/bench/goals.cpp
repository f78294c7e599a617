// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/goals.hpp"

#include <fmt/format.h>

namespace handhold::bench {
namespace {

const Series* find(const std::vector<Series>& all, const std::string& scene, const std::string& engine) {
  for (const Series& series : all)
    if (series.scene == scene && series.engine == engine && !series.medians().empty()) return &series;
  return nullptr;
}

compare::Gate goal(const std::string& quantity, double measured, double limit) {
  return {.quantity = quantity,
          .measured = measured,
          .limit = limit,
          .pedigree = catalogue::Pedigree::published,
          .reason = "the study of today's engines on these scenes"};
}

}  // namespace

std::vector<compare::Gate> goals(const std::vector<Series>& all) {
  std::vector<compare::Gate> list;
  const std::vector<std::pair<std::string, double>> of_ode{{"S1", 0.35}, {"S2", 0.17}, {"S4a", 0.1}, {"S4b", 0.1}};
  for (const auto& [scene, limit] : of_ode) {
    const Series *ours = find(all, scene, "realtime"), *ode = find(all, scene, "ode");
    if (ours && ode)
      list.push_back(goal(fmt::format("{}: realtime / ode", scene), ours->median() / ode->median(), limit));
  }
  const Series* pinch = find(all, "S1", "realtime");
  for (const std::string scene : {"S6a", "S6b"}) {
    const Series* cup = find(all, scene, "realtime");
    if (cup && pinch)
      list.push_back(goal(fmt::format("{} / S1: realtime", scene), cup->median() / pinch->median(), 1.15));
  }
  for (const std::string scene : {"S1", "S2", "S4b", "S6a", "S6b"})  // S4a has a blow in it
    if (const Series* ours = find(all, scene, "realtime"))
      list.push_back(
          goal(fmt::format("{}: p99 / median, realtime", scene), ours->times().p99 / ours->times().p50, 1.5));
  return list;
}

}  // namespace handhold::bench
