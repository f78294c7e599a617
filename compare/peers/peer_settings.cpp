// SPDX-License-Identifier: GPL-3.0-or-later
// The settings found for each engine by the sweeps of docs/benchmarks.md.

#include "compare/peers/peer.hpp"

namespace handhold::compare::peers {
namespace {

/// One setting for hands and one for towers: nobody tunes an engine to each object.
bool is_tower(const std::string& benchmark_id) { return benchmark_id.rfind("S4", 0) == 0; }

PeerSetting ode_setting(const std::string& id) {
  if (is_tower(id)) return {.substeps = 2, .iterations = 50, .stiffness = 5000, .damping = 50};
  if (id.rfind("S3", 0) == 0) return {};
  return {.substeps = 1, .iterations = 20, .stiffness = 2000, .damping = 10};
}

PeerSetting mujoco_setting(const std::string& id) {
  if (is_tower(id)) return {};
  return {.stiffness = 100};
}

PeerSetting dart_setting(const std::string& id) {
  if (is_tower(id) || id.rfind("S3", 0) == 0) return {};
  return {.substeps = 2, .stiffness = 0.5, .damping = 0.01};
}

}  // namespace

PeerSetting grip_setting(const std::string& peer, const std::string& benchmark_id) {
  if (peer == "ode") return ode_setting(benchmark_id);
  if (peer == "mujoco") return mujoco_setting(benchmark_id);
  if (peer == "dart") return dart_setting(benchmark_id);
  return {};
}

}  // namespace handhold::compare::peers
