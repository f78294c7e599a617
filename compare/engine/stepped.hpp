// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Serves the adapters of engines that are stepped frame by frame.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include <fmt/format.h>

#include "cases/model/frame_times.hpp"
#include "cases/model/input_error.hpp"
#include "compare/engine/engine.hpp"
#include "realtime/hand_path.hpp"

namespace handhold::compare {

/// CPU time of this thread [s].
inline double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

/// Where the scene's hands are at t: all that such an engine ever sees of them.
inline void sample_hands(const Scene& scene, double t, std::vector<HandFrame>& hands) {
  for (std::size_t i = 0; i < hands.size(); ++i) {
    const HandMotion& motion = *scene.hands[i].motion;
    hands[i].present = motion.present(t);
    if (!hands[i].present) continue;
    for (int p = 0; p < phalanx_count; ++p) hands[i].X_WP[p] = motion.pose(p, t);
  }
}

/// Ends of the frames that the options ask for. Throws InputError for a rate or times that cannot be.
inline std::vector<double> frames_of(const Scene& scene, const EngineOptions& options) {
  if (!(options.frame_rate > 0) || !std::isfinite(options.frame_rate))
    throw InputError(fmt::format("frame_rate={} Hz: must be finite and > 0 (90 is the default)", options.frame_rate));
  if (options.frame_times.empty()) return regular_frames(scene.duration, options.frame_rate);
  validate_frames(options.frame_times, scene.duration);
  return options.frame_times;
}

inline bool is_finite(const Frame& frame) {
  return std::all_of(frame.bodies.begin(), frame.bodies.end(),
                     [](const BodyState& body) { return body.X_WO.p.allFinite(); });
}

/// Plays the scene from its start to its end, or until `progress` stops it or a body is lost. `Stepper` has time(),
/// advance(dt, hands), events(); `frame_of` turns it into a Frame.
template <class Stepper, class FrameOf>
void stepwise(const Scene& scene, const EngineOptions& options, const Progress& progress, Stepper& stepper,
              const FrameOf& frame_of, Recording& recording) {
  for (const Body& body : scene.bodies) recording.body_names.push_back(body.name);
  std::vector<HandFrame> hands(scene.hands.size());
  recording.frames.push_back(frame_of(stepper));
  for (const double t : frames_of(scene, options)) {
    sample_hands(scene, t, hands);
    const double before = thread_seconds();
    stepper.advance(t - stepper.time(), hands);
    recording.frame_time.push_back(thread_seconds() - before);
    recording.frames.push_back(frame_of(stepper));
    recording.events.insert(recording.events.end(), stepper.events().begin(), stepper.events().end());
    if (!is_finite(recording.frames.back())) {
      recording.outcome = Outcome::diverged;
      recording.note = fmt::format("a body left the finite numbers at t = {:.4g} s", t);
      return;
    }
    if (progress && !progress(t)) {
      recording.outcome = Outcome::interrupted;
      recording.note = fmt::format("stopped at t = {:.4g} s of {:.4g} s", t, scene.duration);
      return;
    }
  }
}

}  // namespace handhold::compare
