// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "cases/catalogue/scenes/benchmark_scenes.hpp"
#include "cases/model/recording.hpp"
#include "compare/peers/peer_model.hpp"

// Today's rigid-body engines on the benchmark scenes. Built only by ./dev bench, and only those whose packages are
// there.

namespace handhold::compare::peers {

/// How an engine is set up. What a field means, and what 0 means, is said at each adapter.
struct PeerSetting {
  int substeps{1};     ///< a frame
  int iterations{};    ///< of the solver
  double stiffness{};  ///< of a contact
  double damping{};    ///< of a contact

  [[nodiscard]] std::string text() const;
};

/// One engine with one scene in it.
class Peer {
 public:
  virtual ~Peer() = default;
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  virtual void set_gravity(const Eigen::Vector3d& gravity) = 0;
  /// Pose that a driven body must have after the next `step`.
  virtual void drive(std::size_t body, const Pose& X_WB) = 0;
  virtual void step() = 0;
  [[nodiscard]] virtual BodyState state(std::size_t body) const = 0;
};

/// "ode", "mujoco", "dart": those that were found when this was built.
[[nodiscard]] const std::vector<std::string>& peer_names();

/// The cheapest setting that was found to hold what is gripped, or to let towers stand (docs/benchmarks.md); stock
/// where it makes no difference or none was found.
[[nodiscard]] PeerSetting grip_setting(const std::string& peer, const std::string& benchmark_id);

/// The model in the engine of that name, which steps by `step` [s]. Throws InputError for an unknown name, and where
/// the engine refuses the model.
[[nodiscard]] std::unique_ptr<Peer> make_peer(const std::string& name, const PeerModel& model,
                                              const PeerSetting& setting, double step);

/// Plays the whole scene; `frame_time` holds the time of each frame's sub-steps on the steady clock, driving the hands
/// included. Without `poses` the recording has no frames.
[[nodiscard]] Recording play(const std::string& name, const catalogue::BenchmarkScene& benchmark,
                             const PeerSetting& setting, double frame_rate, bool poses);

}  // namespace handhold::compare::peers
