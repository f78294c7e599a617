// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/log/log_replay.hpp"

#include <algorithm>
#include <cmath>

#include "cases/hand/phalanx_depth.hpp"
#include "cases/hand/trace_spline.hpp"
#include "compare/study/placing_trial.hpp"

namespace handhold::compare {
namespace {

constexpr double support = 0.05;  // [s]: the springs find their balance first
constexpr double after = 0.5;     // [s]: played beyond the log's last touch

/// Thumb and another part of the hand touch: what one side alone touches is not held.
bool is_taken(const Nearness& near) {
  constexpr unsigned thumb = 7;
  return (near.touching & thumb) != 0 && (near.touching & ~thumb) != 0;
}

/// First frame of the grip before which the object has been taken and slower than 5 cm/s in the palm for 0.1 s.
std::optional<std::size_t> first_rest(const ObjectTrack& o, const LogGrip& grip, const HandMotion& hand) {
  constexpr double while_at_rest = 0.1, slow = 0.05;  // [s], [m/s]
  double rested = 0;                                  // [s], until this frame
  for (std::size_t i = 1; i < o.t.size(); ++i) {
    if (o.t[i - 1] < grip.begin || o.t[i] > grip.end) continue;
    const double step = o.t[i] - o.t[i - 1];
    const auto in_palm = [&](std::size_t k) { return hand.pose(palm, o.t[k]).inverse() * o.center[k]; };
    const bool rests = is_taken(o.near[i]) && (in_palm(i) - in_palm(i - 1)).norm() < slow * step;
    rested = rests ? rested + step : 0;
    if (rested >= while_at_rest) return i;
  }
  return std::nullopt;
}

Placement placement_of(const ObjectTrack& o, std::size_t at, const LogGrip& grip, const HandMotion& hand,
                       const VoxelField& field, double trace_end) {
  Placement placement;
  placement.X_WO = o.X_WO[at];
  placement.start = o.t[at];
  placement.closure = placement.start;
  placement.held_until = std::min(placement.start + support, grip.end);
  placement.until = std::min(grip.end + after, trace_end);
  for (int phalanx = 0; phalanx < palm; ++phalanx) {
    const PhalanxDepth found =
        phalanx_depth(hand.model().shape(phalanx), o.X_WO[at].inverse() * hand.pose(phalanx, o.t[at]), field);
    if (found.depth > 0) placement.touches.push_back({phalanx, found.depth, o.X_WO[at].R * found.n_O});
  }
  return placement;
}

/// The last frame with a contact that is not followed by another; none if the last frame has one.
std::optional<double> last_touch(const Recording& recording) {
  double last = 0;
  for (const Frame& frame : recording.frames) {
    const auto presses = [](const ContactState& c) { return c.mode != Mode::apart; };
    if (std::any_of(frame.contacts.begin(), frame.contacts.end(), presses)) last = frame.t;
  }
  if (recording.frames.empty() || last >= recording.frames.back().t) return std::nullopt;
  return last;
}

double farthest_apart(const ObjectTrack& o, const Recording& recording, double start, double until) {
  double apart = 0;
  std::size_t i = 0;
  for (const Frame& frame : recording.frames) {
    const double t = start + frame.t;
    if (t > until) break;
    while (i + 1 < o.t.size() && o.t[i + 1] <= t) ++i;
    if (i + 1 >= o.t.size()) break;
    const double share = (t - o.t[i]) / (o.t[i + 1] - o.t[i]);
    const Eigen::Vector3d logged = o.X_WO[i].p + share * (o.X_WO[i + 1].p - o.X_WO[i].p);
    apart = std::max(apart, (frame.bodies.front().X_WO.p - logged).norm());
  }
  return apart;
}

}  // namespace

std::optional<LogReplay> replay_grip(const ObjectLog& log, const ObjectTrack& track, const LogGrip& grip,
                                     const Body& body,
                                     const std::function<ContactParameters(const Placement&)>& contact_of,
                                     const Engine& engine) {
  const TraceSpline hand(*log.trace, std::size_t(grip.hand));
  const std::optional<std::size_t> at = first_rest(track, grip, hand);
  if (!at) return std::nullopt;
  const Placement placement = placement_of(track, *at, grip, hand, *body.field, log.trace->t.back());
  if (placement.until <= placement.held_until) return std::nullopt;
  const PlacingRequest request{.trace = &*log.trace, .hand = std::size_t(grip.hand), .body = body};
  Scene scene = scene_of(request, placement, contact_of(placement));
  scene.duration = std::min(scene.duration, placement.until - placement.start);
  EngineOptions options;
  options.accuracy = 1e-6;  // of a replay, whose input errs by tenths of a millimetre
  const Recording recording = engine.play(scene, options);
  LogReplay replay{
      .begin = placement.start, .played_until = placement.start + scene.duration, .outcome = recording.outcome};
  if (const std::optional<double> last = last_touch(recording)) replay.replayed_end = placement.start + *last;
  replay.apart =
      farthest_apart(track, recording, placement.start, std::min(grip.end, replay.replayed_end.value_or(grip.end)));
  return replay;
}

}  // namespace handhold::compare
