// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/peers/peer.hpp"

#include <chrono>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/model/input_error.hpp"
#ifdef HANDHOLD_ODE
#include "compare/peers/ode_peer.hpp"
#endif
#ifdef HANDHOLD_MUJOCO
#include "compare/peers/mujoco_peer.hpp"
#endif
#ifdef HANDHOLD_DART
#include "compare/peers/dart_peer.hpp"
#endif

namespace handhold::compare::peers {
namespace {

using Make = std::function<std::unique_ptr<Peer>(const PeerModel&, const PeerSetting&, double step)>;

const std::vector<std::pair<std::string, Make>>& makers() {
  static const std::vector<std::pair<std::string, Make>> all{
#ifdef HANDHOLD_ODE
      {"ode", make_ode_peer},
#endif
#ifdef HANDHOLD_MUJOCO
      {"mujoco", make_mujoco_peer},
#endif
#ifdef HANDHOLD_DART
      {"dart", make_dart_peer},
#endif
  };
  return all;
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Poses of the hands at the end of every sub-step of a frame; sampled before the clock runs.
class Drive {
 public:
  Drive(const catalogue::BenchmarkScene& benchmark, const PeerModel& model, int substeps)
      : benchmark_(benchmark), model_(model), poses_(std::size_t(substeps) * model.phalanges.size()) {}

  void sample(double begin, double end) {
    const std::size_t count = model_.phalanges.size();
    const std::size_t substeps = count > 0 ? poses_.size() / count : 0;
    for (std::size_t s = 0; s < substeps; ++s)
      for (std::size_t i = 0; i < count; ++i) {
        const auto [hand, phalanx] = model_.phalanges[i];
        const double t = begin + (end - begin) * double(s + 1) / double(substeps);
        poses_[s * count + i] = benchmark_.scene.hands[std::size_t(hand)].motion->pose(phalanx, t);
      }
  }
  void apply(Peer& peer, int substep) const {
    const std::size_t count = model_.phalanges.size();
    for (std::size_t i = 0; i < count; ++i)
      peer.drive(model_.scene_bodies + i, poses_[std::size_t(substep) * count + i]);
  }

 private:
  const catalogue::BenchmarkScene& benchmark_;
  const PeerModel& model_;
  std::vector<Pose> poses_;  // sub-step by sub-step
};

Frame frame_of(const Peer& peer, const PeerModel& model, double t) {
  Frame frame{.t = t};
  for (std::size_t i = 0; i < model.scene_bodies; ++i) frame.bodies.push_back(peer.state(i));
  return frame;
}

}  // namespace

std::string PeerSetting::text() const {
  return fmt::format("substeps {}, iterations {}, spring {:g}, damper {:g}", substeps, iterations, stiffness, damping);
}

const std::vector<std::string>& peer_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const auto& [name, make] : makers()) list.push_back(name);
    return list;
  }();
  return names;
}

std::unique_ptr<Peer> make_peer(const std::string& name, const PeerModel& model, const PeerSetting& setting,
                                double step) {
  for (const auto& [known, make] : makers())
    if (known == name) return make(model, setting, step);
  throw InputError(fmt::format("peer '{}': was not built in (there are: {})", name, fmt::join(peer_names(), ", ")));
}

Recording play(const std::string& name, const catalogue::BenchmarkScene& benchmark, const PeerSetting& setting,
               double frame_rate, bool poses) {
  const PeerModel model = make_peer_model(benchmark);
  const double dt = 1 / frame_rate;
  const std::unique_ptr<Peer> peer = make_peer(name, model, setting, dt / setting.substeps);
  Recording recording{.engine = name, .scene = benchmark.scene.name};
  recording.provenance = {{"setting", setting.text()}, {"frame_rate", fmt::format("{} Hz", frame_rate)}};
  for (const Body& body : benchmark.scene.bodies) recording.body_names.push_back(body.name);
  if (poses) recording.frames.push_back(frame_of(*peer, model, 0));
  Drive drive(benchmark, model, setting.substeps);
  const long frames = std::lround(benchmark.scene.duration * frame_rate);
  for (long k = 0; k < frames; ++k) {
    const double t = double(k) * dt;
    peer->set_gravity(t < model.gravity_from - 1e-9 ? Eigen::Vector3d::Zero() : model.gravity);
    drive.sample(t, t + dt);
    const auto begin = std::chrono::steady_clock::now();
    for (int s = 0; s < setting.substeps; ++s) {
      drive.apply(*peer, s);
      peer->step();
    }
    recording.frame_time.push_back(seconds_since(begin));
    if (!poses) continue;
    recording.frames.push_back(frame_of(*peer, model, double(k + 1) * dt));
    if (!recording.frames.back().bodies.back().X_WO.p.allFinite()) {
      recording.outcome = Outcome::diverged;
      recording.note = fmt::format("left the finite numbers at t = {:.4g} s", t);
      return recording;
    }
  }
  return recording;
}

}  // namespace handhold::compare::peers
