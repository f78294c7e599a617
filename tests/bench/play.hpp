// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cases/model/scene.hpp"
#include "realtime/hand_path.hpp"
#include "realtime/world.hpp"

namespace handhold::bench {

using HandFrames = std::vector<std::vector<HandFrame>>;  ///< a frame, a hand

/// What the hands do at the frames −2, −1, 0, ... of the scene, so that nothing is looked up while the clock runs.
[[nodiscard]] HandFrames hand_frames(const Scene& scene, double frame_rate);

/// Plays the scene in the real-time path; time of each `World::advance` on the steady clock [s]. The processor's own
/// clock takes 0.5 µs to read, as long as a quarter of a frame: frames that were interrupted are told from the others
/// by repeating the scene (see Series). Throws InputError for a scene that World cannot express.
[[nodiscard]] std::vector<double> play_realtime(const Scene& scene, const HandFrames& hands, double frame_rate,
                                                const realtime::Options& setting);

}  // namespace handhold::bench
