// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/engine/paper_player.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cases/model/input_error.hpp"
#include "compare/engine/stepped.hpp"

namespace handhold::compare {
namespace {

namespace paper = realtime::paper;

BodyState state_of(const paper::HostBody& body) {
  const paper::BodyMotion& m = body.motion;
  return {m.X_WO, {m.w, m.v - m.w.cross(m.X_WO.R * body.center_O)}};
}

SampleId id_of(const PlayedPatch& patch, int sample) {
  return {.hand = patch.hand, .phalanx = patch.phalanx, .sample = std::uint8_t(sample)};
}

/// As the force used it: f = γ (p − C) holds with these p and C.
ContactState contact_of(const paper::Middleware& law, std::size_t patch, int sample, const Pose& X_WO) {
  const paper::PatchState& state = law.patches()[patch];
  const paper::SampleState& s = state.samples[std::size_t(sample)];
  ContactState contact{.mode = s.mode, .C_W = X_WO * s.used.C_O, .n_W = X_WO.R * s.used.n_O, .f_W = s.f_W};
  contact.p_W = law.options().point == printed::Point::centroid ? state.X_WP.p : state.X_WP * s.p_P;
  contact.depth = -(contact.p_W - contact.C_W).dot(contact.n_W);
  return contact;
}

Frame frame_of(const Played& played, double t, const BodyState& before) {
  Frame frame{.t = t, .bodies = {before}};
  for (std::size_t k = 0; k < played.patches.size(); ++k) {
    for (int i = 0; i < int(played.patches[k].p_P.size()); ++i) {
      frame.contacts.push_back(contact_of(played.host.middleware(), k, i, before.X_WO));
      frame.contacts.back().id = id_of(played.patches[k], i);
    }
  }
  std::sort(frame.contacts.begin(), frame.contacts.end(),
            [](const ContactState& a, const ContactState& b) { return a.id < b.id; });
  return frame;
}

std::vector<Mode> modes_of(const Played& played) {
  std::vector<Mode> modes;
  for (std::size_t k = 0; k < played.patches.size(); ++k)
    for (std::size_t i = 0; i < played.patches[k].p_P.size(); ++i)
      modes.push_back(played.host.middleware().patches()[k].samples[i].mode);
  return modes;
}

void add_events(const Played& played, const std::vector<Mode>& before, const PlayedFrame& at, const BodyState& body,
                std::vector<Event>& events) {
  const std::vector<Mode> now = modes_of(played);
  std::size_t n = 0;
  for (const PlayedPatch& patch : played.patches)
    for (int i = 0; i < int(patch.p_P.size()); ++i, ++n)
      if (before[n] != now[n]) events.push_back({at.t, at.dt, change_of(before[n], now[n]), id_of(patch, i), body});
}

}  // namespace

paper::HostBody host_body(const Inertia& inertia, Mobility mobility, const Pose& X_WO, const Twist& V_WO) {
  const Eigen::Vector3d v = V_WO.v + V_WO.w.cross(X_WO.R * inertia.center);
  return {.mass = inertia.mass,
          .inertia_O = inertia.about_center,
          .center_O = inertia.center,
          .mobility = mobility,
          .motion = {X_WO, v, V_WO.w}};
}

void seed(Played& played, double reach) {
  paper::Middleware& law = played.host.middleware();
  const Pose& X_WO = played.host.body().motion.X_WO;
  for (std::size_t k = 0; k < played.patches.size(); ++k) {
    const PlayedPatch& patch = played.patches[k];
    const Pose X_WP = patch.pose(0);
    law.seed(int(k), X_WP, X_WO, patch.p_P, reach);
    if (law.patches()[k].count != int(patch.p_P.size()))
      throw InputError(fmt::format(
          "phalanx {}: every sample must be within {} m of the surface at the start (move it nearer)", k, reach));
    for (std::size_t i = 0; i < patch.start.size(); ++i) {
      const Pose X_OW = X_WO.inverse();
      const Eigen::Vector3d p_W = X_WP * patch.p_P[i], p_O = X_OW * p_W;
      const std::optional<paper::Spot> spot = law.surface().closest(X_OW * (p_W - patch.start[i].lag_W), reach);
      if (!spot || (p_O - spot->C_O).dot(spot->n_O) > 0) continue;  // outside: nothing to start
      law.set(int(k), int(i), *spot, patch.start[i].slipping ? Mode::slip : Mode::stick);
    }
  }
}

void play(Played& played, std::span<const PlayedFrame> frames, const Progress& progress, Recording& recording) {
  std::vector<Pose> X_WP(played.patches.size());
  for (const PlayedFrame& at : frames) {
    for (std::size_t k = 0; k < X_WP.size(); ++k) X_WP[k] = played.patches[k].pose(at.t);
    const BodyState before = state_of(played.host.body());
    const std::vector<Mode> modes = modes_of(played);
    const Load load = played.load ? played.load(at.t) : Load{};
    const double start = thread_seconds();
    played.host.advance(at.dt, X_WP, {load.force_W, load.torque_W});
    recording.frame_time.push_back(thread_seconds() - start);
    recording.frames.push_back(frame_of(played, at.t, before));
    add_events(played, modes, at, before, recording.events);
    if (!is_finite(recording.frames.back())) {
      recording.outcome = Outcome::diverged;
      recording.note = fmt::format("the body left the finite numbers at t = {:.4g} s", at.t);
      return;
    }
    if (progress && !progress(at.t)) {
      recording.outcome = Outcome::interrupted;
      recording.note = fmt::format("stopped at t = {:.4g} s of {:.4g} s", at.t, frames.back().t);
      return;
    }
  }
  recording.frame_time.pop_back();  // the last frame only shows its beginning
}

}  // namespace handhold::compare
